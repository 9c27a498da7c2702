// A runner of `cargo xtask bench` (benches/runner has the protocol): the built page in Chromium, by Playwright. Jobs: an input to a race
// that plays, with the name of the input; the opening, with the throttling of the processor and a network. Its argument: the folder of the built page,
// if it is not `www/dist/`.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { createInterface } from 'node:readline'
import { opening } from './page_opening.mjs'
import { PlayingRace } from './page_race.mjs'
import { serveFiles } from './serve_files.mjs'

const root = new URL('../../', import.meta.url)
const { chromium } = createRequire(new URL('www/package.json', root))('@playwright/test')

const folder = new URL(`${process.argv[2] ?? 'www/dist'}/`, root)
const server = await serveFiles(folder, { packed: true })
const executablePath = process.env.CHROMIUM_PATH ?? '/usr/bin/chromium'
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] })

/** The race on a map with these planners: one page for all inputs to it. */
const races = new Map()

function raceOf({ map, planners }) {
  const key = JSON.stringify([map, planners])
  if (!races.has(key)) {
    const text = readFileSync(map, 'utf8')
    races.set(key, PlayingRace.open(browser, server.address, text, planners))
  }
  return races.get(key)
}

async function contestant(job) {
  if (job.work === 'opening') return () => opening(browser, server.address, job)
  const race = await raceOf(job)
  return (seed) => race.input(job.input, seed)
}

const contestants = []
for await (const line of createInterface({ input: process.stdin })) {
  const { prepare, round, seed } = JSON.parse(line)
  const answer = prepare
    ? contestants.push(await contestant(prepare)) - 1
    : await contestants[round](seed)
  console.log(JSON.stringify(answer))
}
await browser.close()
server.close()
