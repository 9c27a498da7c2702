import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

test('a phone shows and runs everything without sideways scrolling @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.open()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
  expect(overflow).toBeLessThanOrEqual(0)
  await expect(page.getByTestId('play')).toBeInViewport()
  await expect(race.stage()).toBeInViewport()
  await page.getByTestId('play').tap()
  await expect(page.getByTestId('play')).toHaveAccessibleName(/play/i)
})

test('targets are large enough for fingers @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  expect(await smallTargets(page), 'at rest').toEqual([])
  await page.getByTestId('column').tap()
  await expect(page.getByTestId('close-column')).toBeVisible()
  expect(await smallTargets(page), 'with the sheet').toEqual([])
  await page.getByTestId('close-column').tap()
  await page.getByTestId('help').tap()
  await expect(page.getByTestId('help-dialog')).toBeVisible()
  expect(await smallTargets(page), 'in a dialog').toEqual([])
})

test('the cards of lessons and their buttons are large enough as well @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
  for (const [item, card] of [
    ['lesson-follow', 'ant-card'],
    ['lesson-guess', 'guess-card'],
    ['lesson-draw', 'draw-card'],
    ['lesson-drive', 'drive-card'],
  ] as const) {
    await page.getByTestId('lesson-menu').tap()
    await page.getByTestId(item).tap()
    await expect(page.getByTestId(card)).toBeVisible()
    await expect(page.getByTestId(card)).toBeInViewport()
    expect(await smallTargets(page), card).toEqual([])
    await page.getByTestId('card-fold').tap()
    expect(await smallTargets(page), `${card}, folded`).toEqual([])
    await page.getByTestId('card-fold').tap()
    await page.getByTestId(`${card}-close`).tap()
  }
})

test('the sheet opens over the maps, and goes', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  const race = new RacePage(page)
  await race.openAtRest()
  await expect(page.getByTestId('seed')).toBeHidden()
  await page.getByTestId('parameters-2').click()
  const tab = page.locator('.panel-tab').nth(1)
  await expect(tab).toHaveAttribute('aria-pressed', 'true')
  await page.getByTestId('speed').fill('2')
  expect((await race.session()).speed).toBe(2)
  await page.getByTestId('seed').fill('7')
  await page.getByTestId('seed').press('Enter')
  expect((await race.session()).seed).toBe(7)
  await page.getByTestId('close-column').click()
  await expect(page.getByTestId('seed')).toBeHidden()
})

/** Controls that a finger could miss: less than 40 CSS pixels wide or high. What is hidden for all but screen readers does not count. */
function smallTargets(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const controls = document.querySelectorAll<HTMLElement>(
      'button, select, input, [role="menuitem"]',
    )
    const seen = [...controls].filter((control) =>
      control.checkVisibility({ visibilityProperty: true }),
    )
    return seen.flatMap((control) => {
      // A label beside a checkbox is pressed as well as the box.
      const pressed = control.closest('label') ?? control
      const { width, height } = pressed.getBoundingClientRect()
      if (width <= 1 || (width >= 40 && height >= 40)) return []
      const name = control.dataset.testid ?? control.className
      return [`${name}: ${Math.round(width)} × ${Math.round(height)}`]
    })
  })
}
