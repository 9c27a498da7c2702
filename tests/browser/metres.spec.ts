/** Lengths in metres, on maps that have a scale. */
import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Locator, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'
import { ResultsPage, richDocument } from './results_page'

const folder = join(process.env.FORMICARIUM_DATA ?? '', 'rosmap')

function robots(name: string): Buffer {
  const path = join(folder, name)
  test.skip(!existsSync(path), `needs rosmap/${name}: set FORMICARIUM_DATA to the folder above it`)
  return readFileSync(path)
}

/** A depot of 30 m with few cells, once its runs have ended. */
async function finishedDepot(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.open()
  await race.dropTogether([
    ['depot.yaml', robots('depot.yaml')],
    ['depot.pgm', robots('depot.pgm')],
  ])
  await page.getByTestId('map-cells').fill('100')
  await page.getByTestId('map-cells').press('Tab')
  await page.getByTestId('map-open').click()
  await race.ready()
  await page.locator('body').press('End')
  for (const place of [1, 2])
    await expect(page.getByTestId(`status-${place}`)).toHaveAttribute(
      'data-status',
      /optimal|budget-spent|stagnated/,
    )
  return race
}

const value = async (field: Locator) => Number(await field.getAttribute('data-value'))

async function chooseUnit(race: RacePage, unit: 'metres' | 'cells') {
  await race.menu('map-menu', 'open-resize')
  await race.page.getByTestId(`lengths-${unit}`).click()
  await race.applyRules()
}

/** CSS pixels of a scale bar. */
const LONGEST = 80

/** By what the page says of the places of two cells. */
async function metresAPixel(race: RacePage): Promise<number> {
  const { page } = race
  const box = await race.box()
  const x: number[] = []
  for (const part of [0.4, 0.6]) {
    await page.mouse.move(box.x + part * box.width, box.y + box.height / 2)
    await race.frame()
    const text = (await page.getByTestId('cell-readout').first().textContent()) ?? ''
    x.push(Number(/x ([\d.]+)/.exec(text)?.[1]))
  }
  return ((x[1] ?? 0) - (x[0] ?? 0)) / (0.2 * box.width)
}

test.describe('a robot’s map', () => {
  test('tells every length in metres, or in cells if the reader wants', async ({ page }) => {
    const race = await finishedDepot(page)
    const { resolution } = (await race.session()).scenario.spec
    expect(resolution).toBeCloseTo(0.35, 9)
    const optimum = page.getByTestId('optimum')
    const best = await value(optimum)
    const metres = (cells: number) => (cells * resolution).toFixed(2)
    await expect(optimum).toHaveText(`Shortest path: ${metres(best)} m`)
    const walked = (await race.result(1)).summary?.metrics
    const length = walked?.length ?? Number.NaN
    await expect(page.getByTestId('readout-length-1')).toHaveText(`${metres(length)} m`)
    const row = (id: string) =>
      page.getByRole('row').filter({ has: page.getByTestId(`metric-${id}-1`) })
    await expect(row('length').getByRole('rowheader')).toHaveText('Length (m)')
    await expect(page.getByTestId('metric-length-1')).toHaveText(metres(length))
    await expect(row('minClearance').getByRole('rowheader')).toHaveText('Least clearance (m)')
    await expect(page.getByTestId('metric-minClearance-1')).toHaveText(
      metres(walked?.min_clearance ?? Number.NaN),
    )
    await expect(row('travelTime').getByRole('rowheader')).toHaveText('Travel time (s)')
    await expect(page.getByTestId('metric-comparedWith-1')).toContainText(`${metres(best)} m`)
    await expect(page.getByTestId('chart-readout')).toContainText(`${metres(length)} m`)
    await expect(page.getByTestId('chart-optimum')).toHaveText(`Optimum ${metres(best)} m`)
    await expect(page.getByTestId('legend-2')).toContainText('Cost from start (m)')
    const ramp = page.getByTestId('legend-2').locator('.legend-ramp')
    const most = Number(await ramp.getAttribute('data-high')) * resolution
    await expect(ramp).toContainText(most.toPrecision(3))
    await expectClean(page, 'a map in metres')

    await chooseUnit(race, 'cells')
    await expect(optimum).toHaveText(`Shortest path: ${best.toFixed(2)}`)
    await expect(row('length').getByRole('rowheader')).toHaveText('Length')
    await expect(page.getByTestId('legend-2')).toContainText('Cost from start (cells)')
    await expect(page.getByTestId('scale-bar-1')).toHaveText(/^\d+ cells?$/)
    expect(await page.evaluate(() => localStorage.getItem('formicarium.lengths'))).toBe('cells')
    await page.reload()
    await race.ready()
    await expect(optimum).toHaveText(`Shortest path: ${best.toFixed(2)}`)
    await chooseUnit(race, 'metres')
    await expect(optimum).toHaveText(`Shortest path: ${metres(best)} m`)
  })

  test('says so to screen readers, in goals and in Chinese', async ({ page }) => {
    const race = await finishedDepot(page)
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    await expect(page.locator('[aria-live]').filter({ hasText: /column \d+.* m$/ })).toHaveCount(1)
    await race.menu('map-menu', 'open-goals')
    await expect(page.getByTestId('goals')).toContainText(/x 29\.\d\d, y 0\.\d\d m/)
    await race.menu('language', 'language-zh-CN')
    const best = await value(page.getByTestId('optimum'))
    await expect(page.getByTestId('optimum')).toHaveText(`最短路径：${(best * 0.35).toFixed(2)} 米`)
    await expect(page.getByTestId('goals')).toContainText(/x 29\.\d\d，y 0\.\d\d 米/)
    await expect(page.getByTestId('scale-bar-1')).toContainText('米')
    await expect(page.getByTestId('legend-2')).toContainText('（米）')
  })

  test('has a scale bar that is as long as it says, at any zoom', async ({ page }) => {
    const race = await finishedDepot(page)
    const bar = page.getByTestId('scale-bar-1')
    const lengths: number[] = []
    for (let zoom = 0; zoom < 2; zoom++) {
      const metresPerPixel = await metresAPixel(race)
      const width = (await bar.locator('.scale-line').boundingBox())?.width ?? 0
      const length = Number(await bar.getAttribute('data-length'))
      await expect(bar).toHaveText(`${length} m`)
      await expect(bar).toHaveAccessibleName(`Scale bar: ${length} m`)
      expect(width).toBeGreaterThan(0.3 * LONGEST)
      expect(width).toBeLessThanOrEqual(LONGEST)
      // Two cells are known to half a cell each.
      expect(Math.abs((width * metresPerPixel) / length - 1)).toBeLessThan(0.1)
      lengths.push(length)
      for (let press = 0; press < 4; press++)
        await page.getByRole('button', { name: 'Zoom in', exact: true }).click()
    }
    expect(lengths[1]).toBeLessThan(lengths[0] ?? 0)
    await page.getByTestId('layer').selectOption('none')
    await expect(page.locator('.layer-legend')).toHaveCount(0)
    await expect(bar).toBeVisible()
  })
})

test('a map without a scale has neither metres nor a bar, until its cells get a size', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.locator('body').press('End')
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  const best = await value(page.getByTestId('optimum'))
  await expect(page.getByTestId('optimum')).toHaveText(`Shortest path: ${best.toFixed(2)}`)
  await expect(page.locator('.layer-legend').first()).toBeVisible()
  await expect(page.locator('.scale-bar')).toHaveCount(0)
  await expect(page.getByTestId('cell-readout')).toHaveCount(0)
  await race.menu('map-menu', 'open-resize')
  await expect(page.getByTestId('no-scale')).toBeVisible()
  await page.getByTestId('resolution').fill('0.001')
  await page.getByTestId('speed-metres').fill('0.25')
  await page.getByTestId('turn-seconds').fill('2')
  await expect(page.getByTestId('lengths-metres')).toHaveAttribute('aria-pressed', 'true')
  await expectClean(page, 'size and moves')
  await race.applyRules()
  await expect(page.getByTestId('optimum')).toHaveText(
    `Shortest path: ${(best * 0.001).toFixed(3)} m`,
  )
  await expect(page.locator('.scale-bar').first()).toBeVisible()
  await page.locator('body').press('End')
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  const metrics = (await race.result(2)).summary?.metrics
  const seconds = (metrics?.length_metres ?? 0) / 0.25 + 2 * (metrics?.turns ?? 0)
  expect(metrics?.travel_time).toBeCloseTo(seconds, 9)
  await page.locator('body').press('Control+z')
  await expect(page.getByTestId('optimum')).toHaveText(`Shortest path: ${best.toFixed(2)}`)
})

test('quantities that cannot be used are refused at their fields, in the engine’s words', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'open-resize')
  const [wrong, apply] = [page.getByTestId('quantity-wrong'), page.getByTestId('resize')]
  for (const [field, typed, said] of [
    ['resolution', '0', 'a positive number of metres'],
    ['speed-metres', '-2', 'a positive number of metres per second'],
    ['turn-seconds', '-1', '0 or a positive number of seconds'],
    ['speed-metres', '2000000', 'up to 1000000'],
  ] as const) {
    const input = page.getByTestId(field)
    const before = await input.inputValue()
    await input.fill(typed)
    await expect(wrong).toContainText(said)
    await expect(input).toHaveAttribute('aria-invalid', 'true')
    await expect(apply).toBeDisabled()
    await input.fill(before)
    await expect(wrong).toHaveCount(0)
    await expect(apply).toBeEnabled()
  }
  await race.leaveDialog()
  await race.menu('language', 'language-zh-CN')
  await race.menu('map-menu', 'open-resize')
  await page.getByTestId('speed-metres').fill('0')
  await expect(wrong).toContainText('不能使用 速度（米/秒） = 0')
})

test.describe('a comparison', () => {
  /** Two maps, whose cells have these sizes. */
  function scaled(...resolutions: number[]): string {
    const document = JSON.parse(richDocument(3))
    for (const [at, resolution] of resolutions.entries()) document.maps[at].resolution = resolution
    return JSON.stringify(document)
  }

  const best = (page: Page) =>
    page.getByTestId('summary-table').getByRole('row', { name: /A\*/ }).getByRole('cell').nth(1)

  test('is in metres where all maps have a scale, each by its own', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(scaled(0.5, 0.02))
    await expect(page.getByTestId('lengths-unit')).toContainText('Lengths in')
    await expect(page.getByTestId('results')).toContainText('Measured: path length (m).')
    const small = Number((await results.rows('small', 'exact'))[0]?.length)
    const wide = Number((await results.rows('wide', 'exact'))[0]?.length)
    await expect(best(page)).toHaveText((small * 0.5).toFixed(2))
    await expect(page.getByTestId('results')).toContainText(
      `exact optimum ${(small * 0.5).toFixed(2)}`,
    )
    await results.tab('matrix')
    await expect(page.getByTestId('matrix-small')).toContainText((small * 0.5).toFixed(2))
    await expect(page.getByTestId('matrix-wide')).toContainText((wide * 0.02).toFixed(2))
    await results.tab('figures')
    await expect(results.picture('values')).toContainText(
      `exact optimum ${(small * 0.5).toFixed(2)}`,
    )
    await results.tab('files')
    await expect(page.getByTestId('results')).toContainText('Lengths in files are in cells')
    await expectClean(page, 'a comparison in metres')
    await results.tab('summary')
    await page.getByTestId('lab-lengths-cells').click()
    await expect(best(page)).toHaveText(small.toFixed(2))
    await expect(page.getByTestId('results')).toContainText('Measured: path length (cells).')
  })

  test('is in cells where a map has no scale, and says so', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(scaled(0.5))
    await expect(page.getByTestId('lengths-unit')).toHaveText(
      'Lengths in cells: not all maps have lengths in metres.',
    )
    const small = Number((await results.rows('small', 'exact'))[0]?.length)
    await expect(best(page)).toHaveText(small.toFixed(2))
  })

  test('says nothing of units where no map has a scale', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(scaled())
    await expect(page.getByTestId('results')).toContainText('Measured: path length (cells).')
    await expect(page.getByTestId('lengths-unit')).toHaveCount(0)
  })
})
