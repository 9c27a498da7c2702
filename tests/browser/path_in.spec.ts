/** Paths from files: each becomes the path by hand on the map on show, measured as that is, or is refused by name. */
import { readFileSync } from 'node:fs'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

/** Five columns and three rows of 2 m with a wall between the ends, its lower left corner at (10, 20). */
const YARD = JSON.stringify({
  format: 'formicarium/scenario@1',
  name: 'yard',
  width: 5,
  height: 3,
  resolution: 2,
  start: [0, 1],
  goals: [{ at: [4, 1] }],
  map: { rows: ['.....', '..@..', '.....'] },
  world: { x: 10, y: 20, yaw: 0, frame: 'map' },
})

const AROUND = [
  [0, 1],
  [0, 0],
  [1, 0],
  [2, 0],
  [3, 0],
  [4, 0],
  [4, 1],
]

/** A Path message with these poses. */
const poses = (...places: [number, number][]) =>
  `header: {frame_id: map}\nposes:\n${places
    .map(
      ([x, y]) =>
        `- pose: {position: {x: ${x}, y: ${y}, z: 0.0}, orientation: {x: 0.0, y: 0.0, z: 0.0, w: 1.0}}\n`,
    )
    .join('')}`

async function openYard(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.evaluate((map) => window.formicarium.load(map), YARD)
  return race
}

const drawnOf = async (race: RacePage) => (await race.session()).lesson?.drawn
const standing = (page: Page) => page.getByTestId('draw-standing')

test('cells of a table become the path by hand, with its length, its gap and a way back', async ({
  page,
}) => {
  const race = await openYard(page)
  await race.importByButton('own.path.csv', `x,y\n${AROUND.map(String).join('\n')}\n`)
  await expect(page.getByTestId('import-dialog')).toBeHidden()
  await expect(standing(page)).toContainText('Complete: length 12.00 m')
  await expect(standing(page)).toContainText('above the reference')
  expect(await drawnOf(race)).toEqual({ label: 'own', path: AROUND })
  await expect(page.getByTestId('metric-length-3')).toHaveAttribute('data-value', '6')
  await expect(page.getByTestId('metric-gap-3')).toHaveAttribute('data-value', /\d/)
  await expect(page.getByTestId('hand-line').first()).toBeVisible()
  await expectClean(page, 'the card of a path from a file')
  await page.getByTestId('draw-undo').click()
  await expect.poll(() => drawnOf(race)).toBeUndefined()
})

test('two columns of bare numbers are cells where they lie on the map, and nothing else', async ({
  page,
}) => {
  const race = await openYard(page)
  await race.importByButton('own.csv', `${AROUND.map(String).join('\n')}\n`)
  await expect(standing(page)).toContainText('Complete: length 12.00 m')
  expect((await drawnOf(race))?.path).toEqual(AROUND)
  // Walls are a map, and beside the map it is what it was before.
  await race.importByButton('walls.csv', '0,1\n0,0\n1,0\n')
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(2)
  await race.importByButton('heights.csv', '70,80\n75,90\n60,61\n')
  await expect(page.getByTestId('terrain-dialog')).toBeVisible()
})

test('what the page has saved it opens again', async ({ page }) => {
  const race = await openYard(page)
  await page.getByTestId('planner-1').selectOption('astar')
  await page.getByTestId('run-to-end').click()
  await expect(page.getByTestId('status-1')).toHaveAttribute('data-status', 'optimal')
  const { path } = await race.result(1)
  for (const format of ['path-csv', 'path-json', 'nav-msgs', 'svg']) {
    await page.getByTestId('save-path-1').click()
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId(`path-${format}`).click(),
    ])
    const file = readFileSync(await download.path())
    await race.importByButton(download.suggestedFilename(), file)
    await expect(standing(page)).toContainText('As good as the reference')
    expect((await drawnOf(race))?.path.flat(), format).toEqual(path?.flat())
    await page.getByTestId('draw-clear').click()
    await expect.poll(() => drawnOf(race)).toBeUndefined()
    await page.getByTestId('draw-done').click()
  }
})

test('metres lie in cells; what is further apart than a step is joined, and that is said', async ({
  page,
}) => {
  const race = await openYard(page)
  await race.dropTogether([['plan.yaml', poses([11, 23], [11, 25], [19, 25], [19, 23])]])
  await expect(standing(page)).toContainText('Complete: length 12.00 m')
  expect((await drawnOf(race))?.path).toEqual(AROUND)
  await expect(page.getByTestId('toast-success')).toContainText('further apart than a step')
})

test('a path from elsewhere to elsewhere may have start and goal at its ends', async ({ page }) => {
  const race = await openYard(page)
  // The other way round.
  const back = [...AROUND].reverse()
  await race.importByButton('back.csv', `x,y\n${back.map(String).join('\n')}\n`)
  await expect(standing(page)).toContainText('The path begins at (4, 1), not at the start')
  await page
    .getByTestId('toast-success')
    .getByRole('button', { name: /to its ends/ })
    .click()
  await expect(standing(page)).toContainText('Complete: length 12.00 m')
  const { start, goals } = (await race.session()).scenario.spec
  expect([start, goals[0]?.at]).toEqual([
    [4, 1],
    [0, 1],
  ])
  // One step of the map.
  await page.getByTestId('draw-done').click()
  await page.getByTestId('undo').click()
  expect((await race.session()).scenario.spec.start).toEqual([0, 1])
})

test('a path that comes with its map is opened on it', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.dropTogether([
    ['own.csv', `x,y\n${AROUND.map(String).join('\n')}\n`],
    ['yard.json', YARD],
  ])
  await expect(standing(page)).toContainText('Complete')
  expect((await race.session()).scenario.spec.name).toBe('yard')
  expect((await drawnOf(race))?.path).toEqual(AROUND)
})

test('a wall in its way is named, and the path is shown all the same', async ({ page }) => {
  const race = await openYard(page)
  await race.paste('x,y\n0,1\n1,1\n2,1\n3,1\n4,1\n')
  await expect(standing(page)).toContainText('(2, 1), is blocked')
  expect((await drawnOf(race))?.path).toHaveLength(5)
})

test('what lies beside the map is refused by name, in both languages, and leaves what there is', async ({
  page,
}) => {
  const race = await openYard(page)
  await race.importByButton('far.yaml', poses([11, 23], [99, 23]))
  const alert = page.getByTestId('import-dialog').getByRole('alert')
  await expect(alert).toContainText('pose 1 (99, 23) lies beside the map')
  await page.keyboard.press('Escape')
  await race.menu('language', 'language-zh-CN')
  await race.importByButton('far.csv', 'x,y\n0,1\n5,1\n')
  await expect(alert).toContainText('第 1 个位置 (5, 1) 在地图之外')
  expect(await drawnOf(race)).toBeUndefined()
})
