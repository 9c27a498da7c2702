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
