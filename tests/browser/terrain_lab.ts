/** What the specs about terrains do more than once. */
import { expect, type Page } from '@playwright/test'
import { Lab } from './lab'
import { ASC } from './rasters'

export const dialog = (page: Page) => page.getByTestId('terrain-dialog')

export const scenarioOf = async (lab: Lab) => (await lab.session()).scenario

/** Heights bit by bit, no data included. */
export async function expectHeights(lab: Lab, expected: ArrayLike<number>): Promise<void> {
  const { heights } = await scenarioOf(lab)
  const same =
    heights?.length === expected.length && heights.every((h, i) => Object.is(h, expected[i]))
  expect(same, `${heights?.slice(0, 40)}`).toBe(true)
}

/** Opens the small grid by its defaults. */
export async function openAsc(page: Page, text = ASC): Promise<Lab> {
  const lab = new Lab(page)
  await lab.openAtRest()
  await lab.paste(text)
  await page.getByTestId('terrain-open').click()
  await expect(dialog(page)).toBeHidden()
  await lab.ready()
  return lab
}

/** Opens a terrain of the gallery, at rest. */
export async function openTerrain(
  page: Page,
  id: 'terrain-hills' | 'terrain-slices',
): Promise<Lab> {
  const lab = new Lab(page)
  await lab.openAtRest()
  await lab.menu('map-menu', `gallery-${id}`)
  await expect
    .poll(() => page.evaluate(() => window.formicarium.session()?.scenario.heights?.length ?? 0))
    .toBeGreaterThan(0)
  await page.evaluate(() => window.formicarium.pause())
  await lab.ready()
  await expect(page.getByTestId('view-solid')).toBeVisible()
  return lab
}
