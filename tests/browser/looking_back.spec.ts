import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

const looking = (page: Page) => page.getByTestId('looking-back')
const digest = async (race: RacePage) => (await race.result(1)).summary?.digest

async function runs(page: Page, iterations: number): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  // Words of the legend come a moment after the picture: the pictures are compared without it.
  await page.evaluate(() => {
    const sheet = new CSSStyleSheet()
    sheet.replaceSync('.legend-space { visibility: hidden }')
    document.adoptedStyleSheets.push(sheet)
  })
  await page.evaluate((count) => window.formicarium.run({ iterations: count }), iterations)
  await expect(page.getByTestId('scrubber')).toBeEnabled()
  return race
}

test.describe('looking back', () => {
  test('an iteration comes back bit for bit, with picture, numbers and chart', async ({ page }) => {
    const race = await runs(page, 4)
    const after4 = await digest(race)
    const picture4 = await race.picture()
    await page.evaluate(() => window.formicarium.run({ iterations: 8 }))
    const after12 = await digest(race)
    const picture12 = await race.picture()
    const length = page.getByTestId('metric-iterations-1')
    await expect(length).toHaveAttribute('data-value', '12')

    await page.getByTestId('scrubber').fill('4')
    await expect(looking(page)).toContainText('Iteration 4 of 12')
    await expect.poll(() => digest(race)).toBe(after4)
    await expect(length).toHaveAttribute('data-value', '4')
    await expect(page.getByTestId('numbers-of')).toContainText('4')
    await expect(page.getByTestId('iteration-1')).toContainText('4')
    await expect.poll(async () => picture4.equals(await race.shot())).toBe(true)

    await page.getByTestId('back-to-now').click()
    await expect(looking(page)).toBeHidden()
    await expect.poll(() => digest(race)).toBe(after12)
    await expect.poll(async () => picture12.equals(await race.shot())).toBe(true)
  })

  test('keys go one iteration back and on, the slider all the way', async ({ page }) => {
    await runs(page, 6)
    const body = page.locator('body')
    await body.press(',')
    await expect(looking(page)).toContainText('Iteration 5 of 6')
    await body.press(',')
    await expect(looking(page)).toContainText('Iteration 4 of 6')
    await body.press('.')
    await expect(looking(page)).toContainText('Iteration 5 of 6')
    await body.press('.')
    await expect(looking(page)).toBeHidden()
    await page.getByTestId('scrubber').focus()
    await page.keyboard.press('Home')
    await expect(looking(page)).toContainText('Iteration 0 of 6')
    await expect(page.getByTestId('look-earlier')).toBeDisabled()
    await page.keyboard.press('End')
    await expect(looking(page)).toBeHidden()
  })

  test('a run goes on from where it stands, never from the past', async ({ page }) => {
    const race = await runs(page, 9)
    const straight = await digest(race)
    await page.getByTestId('reset').click()
    await expect.poll(() => race.antMoves()).toBe(0)
    await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
    await page.evaluate(() => window.formicarium.look(2))
    await expect(looking(page)).toContainText('Iteration 2 of 6')
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await expect(looking(page)).toBeHidden()
    expect((await race.result(1)).history).toHaveLength(9)
    expect(await digest(race)).toBe(straight)
  })

  test('what plays is held for a look, and a finished search shows its last', async ({ page }) => {
    const race = await runs(page, 3)
    await race.setSpeed(4)
    await page.getByTestId('play').click()
    await expect.poll(async () => (await race.result(1)).summary?.iteration ?? 0).toBeGreaterThan(5)
    await expect(page.getByTestId('scrubber')).toBeDisabled()
    await page.locator('body').press(',')
    await expect(looking(page)).toBeVisible()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'paused')
    const held = await digest(race)
    await page.waitForTimeout(300)
    expect(await digest(race)).toBe(held)
    await page.getByTestId('run-to-end').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'finished', {
      timeout: 30_000,
    })
    const search = (await race.result(2)).summary
    expect(search?.status).toBe('optimal')
    const last = Number(await page.getByTestId('scrubber').getAttribute('max'))
    await page.evaluate((iteration) => window.formicarium.look(iteration), last - 1)
    expect((await race.result(2)).summary?.digest).toBe(search?.digest)
  })

  test('reset and a changed parameter leave the past', async ({ page }) => {
    const race = await runs(page, 5)
    await page.locator('body').press(',')
    await expect(looking(page)).toBeVisible()
    await page.getByTestId('reset').click()
    await expect(looking(page)).toBeHidden()
    await expect.poll(() => race.antMoves()).toBe(0)
    await expect(page.getByTestId('scrubber')).toBeDisabled()
  })

  test('memory is told, and axe finds nothing serious while looking back', async ({ page }) => {
    await runs(page, 5)
    await expect(page.getByTestId('scrubber')).toHaveAttribute('title', /64 MiB.*Snapshots now/)
    await page.locator('body').press(',')
    await expect(looking(page)).toBeVisible()
    await expectClean(page, 'looking back')
  })

  test('on a phone the slider fits and works @phone', async ({ page }) => {
    await runs(page, 5)
    await page.getByTestId('look-earlier').click()
    await expect(looking(page)).toContainText('Iteration 4 of 5')
    const box = await page.getByTestId('scrubber').boundingBox()
    expect(box?.width).toBeGreaterThan(180)
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth)
    expect(wide).toBe(false)
    await page.getByTestId('back-to-now').click()
    await expect(looking(page)).toBeHidden()
  })
})
