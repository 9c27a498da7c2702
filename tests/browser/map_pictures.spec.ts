/** Maps are seen before they are opened: in the menu, and while one chooses what is generated. */
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

/** The picture as it is drawn: how many of its pixels are dark. */
const walls = (page: Page) =>
  page.getByTestId('generated').evaluate((element) => {
    const canvas = element.querySelector('canvas')
    const pixels = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data
    let dark = 0
    for (let i = 0; pixels && i < pixels.length; i += 4) dark += Number((pixels[i] ?? 0) < 128)
    return [canvas?.width ?? 0, canvas?.height ?? 0, dark]
  })

async function type(page: Page, field: string, value: string): Promise<void> {
  await page.getByTestId(`generate-${field}`).fill(value)
  await page.getByTestId(`generate-${field}`).press('Tab')
}

test('the generator shows the very map that it makes, also after the last of many choices', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'open-generate')
  const preview = page.getByTestId('generated')
  await expect(preview).toHaveAttribute('data-settled', 'true')
  const box = await preview.boundingBox()
  for (const density of ['10', '45', '20', '35']) await type(page, 'density', density)
  await type(page, 'width', '60')
  await expect(preview).toHaveAttribute('data-settled', 'true')
  expect(await preview.boundingBox()).toEqual(box)
  const [width, height, dark] = await walls(page)
  expect([width, height]).toEqual([60, 30])
  await page.getByTestId('generate').click()
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(60)
  expect(await race.walls()).toBe(dark)
  expect((await race.session()).scenario.origin).toEqual({
    generator: 'random',
    seed: 1,
    density: 0.35,
  })
})

test('a map too large to be looked at is not drawn, and that is said', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'open-generate')
  await expect(page.getByTestId('generated').locator('canvas')).toBeVisible()
  await type(page, 'width', '2048')
  await type(page, 'height', '2048')
  await expect(page.getByTestId('generated').locator('canvas')).toHaveCount(0)
  await expect(page.getByTestId('generated')).toContainText(/once it has been made/i)
})

test('every built-in map has a picture, and no item moves when it comes', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('map-menu').click()
  const items = page.locator('[data-testid^="gallery-"]')
  const places = () => items.evaluateAll((all) => all.map((item) => item.getBoundingClientRect().y))
  const before = await places()
  await expect(items.locator('canvas')).toHaveCount(before.length)
  expect(await places()).toEqual(before)
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(20)
})
