// A runner of `cargo xtask bench` (benches/runner has the protocol): the engine in Chromium, by Playwright.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { createInterface } from 'node:readline'
import { serveFiles } from './serve_files.mjs'

const root = new URL('../../', import.meta.url)
const { chromium } = createRequire(new URL('www/package.json', root))('@playwright/test')

const server = await serveFiles(root, { blank: true })
const executablePath = process.env.CHROMIUM_PATH ?? '/usr/bin/chromium'
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] })
const page = await browser.newPage()
await page.goto(server.address)
await page.evaluate(async () => {
  const [engine, jobs, maps] = await Promise.all([
    import('/pkg/formicarium.js'),
    import('/benches/peers/engine.mjs'),
    import('/benches/peers/map.mjs'),
  ])
  await engine.default({ module_or_path: '/pkg/formicarium_bg.wasm' })
  const contestants = []
  window.prepare = (text, job) =>
    contestants.push(jobs.contestant(engine, maps.parse(text), job)) - 1
  window.round = (number, seed) => contestants[number](seed)
})

for await (const line of createInterface({ input: process.stdin })) {
  const { prepare, round, seed } = JSON.parse(line)
  const answer = prepare
    ? await page.evaluate(
        ([text, job]) => window.prepare(text, job),
        [readFileSync(prepare.map, 'utf8'), prepare],
      )
    : await page.evaluate(([round, seed]) => window.round(round, seed), [round, seed])
  console.log(JSON.stringify(answer))
}
await browser.close()
server.close()
