/** What the colours of the maps mean: the values beside them are the engine's, and all panels can share a scale. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { openTerrain } from './terrain_page'

const PKG = join(__dirname, '../../pkg')
const ITERATIONS = 12

const ramp = (page: Page, place: number) =>
  page.getByTestId(`panel-${place}`).locator('.legend-ramp').first()

async function ends(page: Page, place: number): Promise<number[]> {
  const read = (name: string) => ramp(page, place).getAttribute(name)
  return [Number(await read('data-low')), Number(await read('data-high'))]
}

/** Least and greatest value of a layer over the free cells, as an engine of its own has them. */
async function extentOf(race: RacePage, place: number, layer: 'trail' | 'cost'): Promise<number[]> {
  const engine: typeof import('@pkg/formicarium') = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  const { scenario, panels, seed } = await race.session()
  const { planner = '', params = {} } = panels[place - 1] ?? {}
  const run = new engine.Run(scenario.spec, scenario.cells, null, null, planner, params, seed)
  while (run.status() === 'running' && run.iteration() < ITERATIONS) run.advance('iteration', 1)
  const values = [...run.layer(layer)].filter(
    (value, cell) => Number.isFinite(value) && scenario.cells[cell] === 0,
  )
  run.free()
  return [Math.min(...values), Math.max(...values)]
}

test('the ramp of a layer goes from its least value to its greatest', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate((count) => window.formicarium.run({ iterations: count }), ITERATIONS)
  const trail = await extentOf(race, 1, 'trail')
  await expect.poll(() => ends(page, 1)).toEqual(trail)
  expect(trail[1]).toBeGreaterThan(trail[0] ?? 0)
  await expect(ramp(page, 1)).toContainText('Pheromone (τ)')
  await expect.poll(() => ends(page, 2)).toEqual(await extentOf(race, 2, 'cost'))
  await expect(ramp(page, 2)).toContainText('Cost from start (cells)')
  // What a search has expanded is yes or no.
  await page.getByTestId('layer').selectOption('visits')
  await expect(page.getByTestId('panel-2').locator('.legend-swatches')).toContainText('expanded')
  await page.getByTestId('layer').selectOption('none')
  await expect(page.locator('.layer-legend')).toHaveCount(0)
})

test('all panels can draw a layer by one scale, and the page remembers it', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('add-panel', 'add-max-min-ant-system')
  await expect(page.getByTestId('panel-3')).toBeVisible()
  await race.ready()
  await page.evaluate((count) => window.formicarium.run({ iterations: count }), ITERATIONS)
  const [one, other] = [await extentOf(race, 1, 'trail'), await extentOf(race, 3, 'trail')]
  await expect.poll(() => ends(page, 1)).toEqual(one)
  await expect.poll(() => ends(page, 3)).toEqual(other)
  const both = [Math.min(...one, ...other), Math.max(...one, ...other)]
  const weaker = (one[1] ?? 0) < (other[1] ?? 0) ? 1 : 3
  await race.seesMotion(weaker, () => page.getByTestId('same-scale').click())
  for (const place of [1, 3]) await expect.poll(() => ends(page, place)).toEqual(both)
  await expect(ramp(page, 2)).not.toContainText('same scale')
  await page.reload()
  await race.ready()
  await expect(page.getByTestId('same-scale')).toHaveAttribute('aria-pressed', 'true')
})

test('a terrain has the heights of its ground, from above and in three dimensions', async ({
  page,
}) => {
  const race = await openTerrain(page, 'terrain-hills')
  const { heights, spec } = (await race.session()).scenario
  const metres = [...(heights ?? [])]
    .filter(Number.isFinite)
    .map((h) => h * (spec.terrain?.vertical_unit ?? 1))
  await page.getByTestId('layer').selectOption('none')
  const range = [Math.min(...metres), Math.max(...metres)]
  await expect.poll(() => ends(page, 1)).toEqual(range)
  await page.getByTestId('view-solid').click()
  await expect(page.locator('.stage.relief').first()).toBeVisible()
  await expect.poll(() => ends(page, 1)).toEqual(range)
})

test('small stages have no room for it, and it takes no press', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
  const legend = page.getByTestId('panel-1').locator('.layer-legend')
  await expect(legend).toBeVisible()
  const at = await legend.boundingBox()
  const hit = await page.evaluate(
    ([x = 0, y = 0]) => document.elementFromPoint(x, y)?.closest('.layer-legend') ?? null,
    [(at?.x ?? 0) + 20, (at?.y ?? 0) + 10],
  )
  expect(hit).toBeNull()
  await page
    .locator('.panel-stage')
    .first()
    .evaluate((stage) => {
      ;(stage as HTMLElement).style.maxWidth = '230px'
    })
  await expect(legend).toBeHidden()
})
