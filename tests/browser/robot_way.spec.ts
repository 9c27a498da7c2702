/** A robot's whole way through the page: its map drawn, its race run, its drive driven, its path taken away and read elsewhere. */
import { readFileSync } from 'node:fs'
import { expect, type Locator, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { relativeGap } from '../../www/src/model/gap'
import { answered, commandLine } from './command_line'
import { RacePage } from './race_page'

/** Columns and rows, and metres a cell. */
const [WIDTH, HEIGHT, CELL] = [14, 9, 0.5]
const START: Cell = [1, 4]
const GOAL: Cell = [12, 4]

const value = async (field: Locator) => Number(await field.getAttribute('data-value'))
const inMetres = (cells: number) => `${(CELL * cells).toFixed(2)} m`

/** An open floor of this size, for a robot of one cell to each side. */
async function openFloor(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await race.menu('map-menu', 'open-resize')
  await page.getByTestId('resize-width').fill(String(WIDTH))
  await page.getByTestId('resize-height').fill(String(HEIGHT))
  await page.getByTestId('resolution').fill(String(CELL))
  await page.getByTestId('robot-round').click()
  await page.getByTestId('robot-radius').fill(String(CELL))
  await expect(page.getByTestId('robot-fields').locator('.hint')).toHaveText(/^1 cell\. /)
  await race.applyRules()
  return race
}

/** A wall from above and dear ground behind it, by mouse and by keys. */
async function furnish(race: RacePage): Promise<void> {
  const { page } = race
  await page.keyboard.press('s')
  await race.drag([START])
  await page.keyboard.press('g')
  await race.drag([GOAL])
  await page.keyboard.press('w')
  await race.drag([
    [5, 0],
    [5, 4],
  ])
  await page.keyboard.press('u')
  await race.drag([
    [8, 3],
    [8, 8],
  ])
  await race.stage().focus()
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('Enter')
  const { spec, cells, factors } = (await race.session()).scenario
  const at = ([x, y]: Cell) => WIDTH * y + x
  expect([spec.start, spec.goals[0]?.at, spec.robot]).toEqual([START, GOAL, { radius: CELL }])
  expect([spec.width, spec.height, spec.resolution]).toEqual([WIDTH, HEIGHT, CELL])
  expect([cells[at([5, 0])], cells[at([5, 4])], cells[at([5, 5])]]).toEqual([1, 1, 0])
  expect([factors?.[at([8, 3])], factors?.[at([8, 8])], factors?.[at([8, 2])]]).toEqual([3, 3, 1])
}

async function raced(race: RacePage): Promise<void> {
  const { page } = race
  await page.getByTestId('planner-1').selectOption('max-min-ant-system')
  await page.getByTestId('planner-2').selectOption('astar')
  await race.ready()
  await page.locator('body').press('End')
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
}

async function saved(page: Page, format: string): Promise<string> {
  await page.getByTestId('save-path-2').click()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(`path-${format}`).click(),
  ])
  return readFileSync(await download.path(), 'utf8')
}

interface Checked {
  ok: boolean
  metrics: { length: number; cost?: number }
}

interface Drive {
  length: number
  clairvoyant: { value: number }
  ratio: number
  replans: number
}

test('a robot is given a map, raced, driven and sent on its way', async ({ page }) => {
  const cli = commandLine()
  const race = await openFloor(page)
  await furnish(race)
  await raced(race)

  await test.step('cost, metres and optimum fit', async () => {
    const [colony, search] = await race.results()
    const [found, best] = [colony?.summary, search?.summary]
    const { cost = Number.NaN, length = Number.NaN, length_metres } = best?.metrics ?? {}
    expect(best?.value).toBe(cost)
    expect(cost).toBeGreaterThan(length)
    expect(length_metres).toBe(CELL * length)
    expect(await value(page.getByTestId('optimum'))).toBe(cost)
    await expect(page.getByTestId('optimum')).toContainText(inMetres(cost))
    await expect(page.getByTestId('readout-length-2')).toHaveText(inMetres(length))
    await expect(page.getByTestId('readout-value-2')).toHaveText(inMetres(cost))
    expect(await value(page.getByTestId('metric-cost-2'))).toBe(cost)
    expect(await race.attribute('gap-2', 'data-gap')).toBe('0')
    const dearer = found?.value ?? Number.NaN
    expect(dearer).toBeGreaterThanOrEqual(cost)
    expect(await race.attribute('gap-1', 'data-gap')).toBe(String(relativeGap(dearer, cost)))
  })

  await test.step('its path reads the same elsewhere', async () => {
    const map = (await race.exported('scenario')).bytes
    const { path, summary } = await race.result(2)
    const metrics = { length: summary?.metrics?.length, cost: summary?.metrics?.cost }
    const csv = await saved(page, 'path-csv')
    const places = csv.trim().split('\n').slice(1)
    expect(places.map((line) => line.split(',').slice(0, 2).map(Number))).toEqual(path)
    const yaml = await saved(page, 'nav-msgs')
    const of = (axis: 'x' | 'y') =>
      [...yaml.matchAll(new RegExp(`position:\\s+(?:x: .*\\s+)?${axis}: (.*)`, 'g'))].map(
        ([, metres]) => Number(metres),
      )
    const [x, y] = [of('x'), of('y')]
    const middle = ([column, row]: Cell) => [CELL * (column + 0.5), CELL * (HEIGHT - row - 0.5)]
    expect([x[0], y[0]]).toEqual(middle(START))
    expect(x.map((metres, i) => [metres, y[i]])).toEqual(path?.map(middle))
    for (const [name, text] of Object.entries({ 'path.csv': csv, 'path.yaml': yaml })) {
      const files = { 'map.json': map, [name]: text }
      const checked = answered<Checked>(cli, files, ['check', name, '--map', 'map.json'])
      expect(checked).toMatchObject({ ok: true, metrics })
    }
  })

  await test.step('it drives among what moves and what appears', async () => {
    await page.getByTestId('lesson-menu').click()
    await page.getByTestId('lesson-drive').click()
    await page.getByTestId('drive-planner').selectOption({ index: 1 })
    // What stands on the map now are no values of a layer, but as large as ever.
    await expect(page.getByTestId('scale-bar-2')).toBeVisible()
    await expect(page.getByTestId('legend-2')).toBeHidden()
    const ahead = (await race.result(2)).path ?? []
    await page.getByTestId('add-walls').click()
    const wall = ahead.at(8)
    if (!wall) throw new Error('the path is too short')
    await race.drag([wall], 2)
    await page.getByTestId('walls-at_step').fill('4')
    await page.getByTestId('walls-at_step').press('Tab')
    await page.getByTestId('drive-done').click()
    await page.getByTestId('add-obstacle').focus()
    await page.keyboard.press('Enter')
    await race.drag([
      [10, 1],
      [10, 6],
    ])
    await page.getByTestId('drive-done').click()
    const { drive } = (await race.session()).scenario.spec
    expect(drive?.changes).toEqual([{ at_step: 4, blocked: [wall], freed: [] }])
    expect(drive?.tracks?.map(({ cells }) => cells.length)).toEqual([6])
    await expect(page.getByTestId('drive-play')).toBeEnabled()
    await page.getByTestId('drive-pace').selectOption('100')
    await page.getByTestId('drive-play').focus()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('drive-standing')).toContainText('Arrived')
    await expect(page.getByTestId('drive-best')).toHaveAttribute('data-value', /\d/)
    const [length, cost, best, ratio, replans] = await Promise.all(
      ['length', 'cost', 'best', 'ratio', 'replans'].map((what) =>
        value(page.getByTestId(`drive-${what}`)),
      ),
    )
    expect(replans).toBeGreaterThan(0)
    // On weighted ground what compares is the cost, which is no length.
    expect(cost).toBeGreaterThanOrEqual(length ?? 0)
    expect(ratio).toBe((cost ?? 0) / (best ?? 0))
    await expect(page.getByTestId('drive-length')).toHaveText(inMetres(length ?? 0))
    await expect(page.getByTestId('drive-cost')).toHaveText(inMetres(cost ?? 0))
    await expect(page.getByTestId('drive-best')).toHaveText(inMetres(best ?? 0))
    const seed = String((await race.session()).seed)
    const map = (await race.exported('scenario')).bytes
    const args = ['drive', 'map.json', '--planner', 'astar', '--seed', seed]
    expect(answered<Drive>(cli, { 'map.json': map }, args)).toMatchObject({
      length,
      cost,
      clairvoyant: { value: best },
      ratio,
      replans,
    })
  })
})
