/** The cursor of the charts: by pointer and keys it tells the values, looks back, looks into cells, and zooms. */
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { openTerrain } from './terrain_page'

const ITERATIONS = 20

const readout = (page: Page) => page.getByTestId('chart-readout')
const at = (page: Page, iteration: number) =>
  expect(readout(page)).toHaveAttribute('data-iteration', String(iteration))

async function openRun(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate((count) => window.formicarium.run({ iterations: count }), ITERATIONS)
  await expect(page.getByTestId('chart').locator('.u-over')).toBeVisible()
  await at(page, ITERATIONS)
  return race
}

/** A point of the plot, as parts of its width and height. */
async function pointOf(page: Page, chart: string, across: number): Promise<[number, number]> {
  const box = await page.getByTestId(chart).locator('.u-over').boundingBox()
  if (!box) throw new Error('the plot is not on screen')
  return [box.x + across * box.width, box.y + box.height / 2]
}

test('keys move the cursor, and the values are those of the run', async ({ page }) => {
  const race = await openRun(page)
  const chart = page.getByTestId('chart')
  await chart.focus()
  await page.keyboard.press('Home')
  await at(page, 1)
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('ArrowRight')
  await at(page, 3)
  const [, best = 0, iterationBest = 0, mean = 0] = (await race.result(1)).history[2] ?? []
  const numbers = [best, iterationBest, mean].map((value) => value.toFixed(2))
  await expect(readout(page).locator('tbody tr').first().locator('td')).toHaveText(numbers)
  for (const number of numbers)
    await expect(chart).toHaveAttribute('aria-valuetext', new RegExp(number))
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('looking-back')).toBeVisible()
  await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(3)
})

test('a press looks back, a drag zooms, a double press shows all and changes nothing else', async ({
  page,
}) => {
  const race = await openRun(page)
  // Once the plot has all of the run: until then a press in the middle means less.
  await page.mouse.move(...(await pointOf(page, 'chart', 0.5)))
  await at(page, ITERATIONS / 2)
  await page.mouse.click(...(await pointOf(page, 'chart', 0.5)))
  await expect(page.getByTestId('looking-back')).toBeVisible()
  const looked = await page.getByTestId('scrubber').inputValue()
  await at(page, Number(looked))
  expect(Math.abs(Number(looked) - ITERATIONS / 2)).toBeLessThan(2)
  await page.mouse.move(...(await pointOf(page, 'chart', 0.6)))
  await page.mouse.down()
  await page.mouse.move(...(await pointOf(page, 'chart', 0.7)))
  await page.mouse.move(...(await pointOf(page, 'chart', 0.9)))
  await page.mouse.up()
  await expect(page.getByTestId('chart-reset')).toBeVisible()
  // The whole width is now the part that was drawn over.
  await page.mouse.move(...(await pointOf(page, 'chart', 0.01)))
  await expect
    .poll(async () => Number(await readout(page).getAttribute('data-iteration')))
    .toBeGreaterThan(ITERATIONS / 2)
  await page.mouse.dblclick(...(await pointOf(page, 'chart', 0.5)))
  await expect(page.getByTestId('chart-reset')).toBeHidden()
  expect(await page.getByTestId('scrubber').inputValue()).toBe(looked)
  expect((await race.result(1)).summary?.iteration).toBe(Number(looked))
})

test('zoom and its end by keys', async ({ page }) => {
  await openRun(page)
  await page.getByTestId('chart').focus()
  await page.keyboard.press('+')
  await expect(page.getByTestId('chart-reset')).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('chart-reset')).toBeHidden()
})

test('while a race runs, a press holds it and looks back', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('play').click()
  await expect.poll(async () => (await race.result(1)).summary?.iteration ?? 0).toBeGreaterThan(3)
  await expect(page.getByTestId('chart').locator('.u-over')).toBeVisible()
  await page.getByTestId('chart').focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('looking-back')).toBeVisible()
  await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(1)
})

test('the profile tells heights, and looks into the cell', async ({ page }) => {
  const race = await openTerrain(page, 'terrain-hills')
  await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
  await page.getByTestId('chart-profile').click()
  await expect(page.getByTestId('profile').locator('.u-over')).toBeVisible()
  const { altitudes, path } = await race.result(1)
  const first = page.getByTestId('profile-readout').locator('tbody tr').first().locator('td')
  await page.getByTestId('profile').focus()
  await page.keyboard.press('Home')
  const metres = (value: number) => `${Number(value.toFixed(2)).toLocaleString('en')} m`
  await expect(first).toHaveText([metres(altitudes?.[0] ?? 0), (path?.[0] ?? []).join(', ')])
  await page.keyboard.press('ArrowRight')
  await expect(page.getByTestId('profile-readout')).not.toHaveAttribute('data-distance', '0')
  const cell = (await first.nth(1).textContent()) ?? ''
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('moves-card')).toContainText(`(${cell})`)
})
