// A runner of `cargo xtask bench` (benches/runner has the protocol): the engine in Chromium, by Playwright.
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import { createInterface } from 'node:readline'

const root = new URL('../../', import.meta.url)
const { chromium } = createRequire(new URL('www/package.json', root))('@playwright/test')

const TYPES = { js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm' }

/** What the page imports; with these headers its clock has its full resolution. */
const server = createServer((request, response) => {
  const path = request.url.slice(1)
  response.setHeader('Cross-Origin-Opener-Policy', 'same-origin')
  response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp')
  if (path === '') return response.setHeader('Content-Type', 'text/html').end('<!doctype html>')
  try {
    const file = readFileSync(new URL(path, root))
    response.setHeader('Content-Type', TYPES[path.split('.').at(-1)] ?? 'text/plain').end(file)
  } catch {
    response.writeHead(404).end()
  }
})
await new Promise((ready) => server.listen(0, '127.0.0.1', ready))

const executablePath = process.env.CHROMIUM_PATH ?? '/usr/bin/chromium'
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] })
const page = await browser.newPage()
await page.goto(`http://127.0.0.1:${server.address().port}/`)
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
