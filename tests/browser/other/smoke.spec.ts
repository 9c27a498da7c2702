/** What people do first, in every browser: a map comes in, planners race on it and are compared, a link and a reload bring it back. */
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect } from '@playwright/test'
import { StaticHost } from '../static_host'
import { test } from './browsers'

const MAP = `type octile
height 6
width 9
map
.........
.@@@@@...
.....@.@.
.@@@.@.@.
...@...@.
.........
`
const PLANNERS = ['ant-system', 'max-min-ant-system', 'fire', 'astar']
/** A planner that only the whole engine has. */
const LATER = 'max-min-ant-system'

const cli = process.env.FORMICARIUM_CLI

test('a map comes in, and is raced on to the digests of the command line', async ({ other }) => {
  test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')
  const { race } = other
  await race.openAtRest()
  await race.evaluate(async (map) => {
    await window.formicarium.load(new File([map], 'small.map'))
  }, MAP)
  const ends = ['--from', '0,0', '--to', '8,5']
  const seen = await race.evaluate(async (planners) => {
    const session = window.formicarium.session()
    if (!session) throw new Error('there is no session')
    const [goal] = session.scenario.spec.goals
    if (!goal) throw new Error('there is no goal')
    session.scenario.spec.start = [0, 0]
    session.scenario.spec.goals = [{ ...goal, at: [8, 5] }]
    session.seed = 7
    session.panels = planners.map((planner) => ({
      planner,
      preset: null,
      params: {},
      label: null,
      result: null,
    }))
    await window.formicarium.load(session)
    const results = await window.formicarium.run()
    return results.map(({ planner, summary }) => [planner, summary?.digest])
  }, PLANNERS)
  const folder = mkdtempSync(join(tmpdir(), 'formicarium-smoke-'))
  writeFileSync(join(folder, 'small.map'), MAP)
  const digest = (planner: string) => {
    const args = ['plan', 'small.map', ...ends, '--seed', '7', '--planner', planner]
    const told = execFileSync(cli ?? '', [...args, '--format', 'json'], { cwd: folder })
    return JSON.parse(told.toString()).digest
  }
  expect(seen).toEqual(PLANNERS.map((planner) => [planner, digest(planner)]))
})

test('a comparison has the bytes of the command line', async ({ other }) => {
  test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')
  const { race } = other
  await race.openAtRest()
  const files = await race.ask(async () => {
    const options = { planners: ['ant-system', 'astar'], seeds: 3, command: 'again' }
    return (await window.formicarium.compare(options)).files
  })
  const folder = mkdtempSync(join(tmpdir(), 'formicarium-smoke-'))
  writeFileSync(join(folder, 'small.json'), files.json)
  execFileSync(cli ?? '', ['compare', 'small.json', '--out', 'again'], { cwd: folder })
  expect(readFileSync(join(folder, 'again/small.csv'), 'utf8')).toBe(files.csv)
})

test('a reload keeps what was drawn and chosen', async ({ other }) => {
  const { race } = other
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await race.evaluate(async (planner) => {
    const session = window.formicarium.session()
    const [panel] = session?.panels ?? []
    if (!session || !panel) throw new Error('there is no panel')
    session.scenario.cells[40] = 1
    session.panels = [{ ...panel, planner, result: null }]
    await window.formicarium.load(session)
  }, LATER)
  const stored = () => race.ask(() => sessionStorage.getItem('formicarium.session') !== null)
  await expect.poll(stored).toBe(true)
  // What was drawn last has been packed by then.
  await new Promise((resolve) => setTimeout(resolve, 1500))
  await race.open()
  expect(await race.walls()).toBe(1)
  expect((await race.session()).panels[0]?.planner).toBe(LATER)
})

test('a part that did not come is there when it is asked for again', async ({ other }) => {
  const host = await StaticHost.start()
  const { race } = other
  await race.open(host.address)
  const selector = `option[value="${LATER}"]`
  await expect
    .poll(() => race.evaluate((option) => document.querySelector(option) !== null, selector))
    .toBe(true)
  host.breakConnections(true)
  await race.press('view-lab')
  const toast = () =>
    race.ask(() => document.querySelector('[data-testid="toast-error"]')?.textContent ?? '')
  await expect.poll(toast).toContain('could not be fetched')
  host.breakConnections(false)
  await race.press('view-lab')
  const builder = () => race.ask(() => document.querySelector('[data-testid="lab"]') !== null)
  await expect.poll(builder).toBe(true)
  host.remove()
})

test('without WebGL a terrain is seen from above, and nothing is logged for each key', async ({
  other,
}) => {
  const { race } = other
  await race.openAtRest()
  await race.ask(() => {
    const broken: string[] = []
    Object.assign(window, { broken })
    const write = console.error
    console.error = (...words) => {
      broken.push(words.map(String).join(' '))
      write(...words)
    }
    OffscreenCanvas.prototype.getContext = new Proxy(OffscreenCanvas.prototype.getContext, {
      apply: (get, canvas, [kind, ...rest]) =>
        /webgl/.test(kind) ? null : Reflect.apply(get, canvas, [kind, ...rest]),
    })
  })
  await race.menu('map-menu', 'gallery-terrain-hills')
  await expect.poll(async () => (await race.session()).scenario.heights !== null).toBe(true)
  await race.ready()
  const press = () => race.ask(() => dispatchEvent(new KeyboardEvent('keydown', { key: '3' })))
  await press()
  await press()
  const warned = () =>
    race.ask(() => document.querySelector('[data-testid="toast-warning"]')?.textContent ?? '')
  await expect.poll(warned).toContain('WebGL')
  expect(await race.ask(() => (window as unknown as { broken: string[] }).broken)).toEqual([])
})
