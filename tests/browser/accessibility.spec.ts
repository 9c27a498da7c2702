import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious at rest, running, or in any dialog (${scheme})`, async ({
    page,
  }) => {
    test.slow()
    await page.emulateMedia({ colorScheme: scheme })
    const race = new RacePage(page)
    await race.openAtRest()
    await expectClean(page, 'at rest')
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await expectClean(page, 'running')
    await page.getByTestId('play').click()
    for (const item of ['open-generate', 'open-resize', 'open-import', 'open-export']) {
      await race.menu('map-menu', item)
      await expect(page.locator('dialog')).toBeVisible()
      await expectClean(page, item)
      await race.leaveDialog()
    }
    for (const button of ['share', 'help']) {
      await page.getByTestId(button).click()
      await expect(page.locator('dialog')).toBeVisible()
      await expectClean(page, button)
      await race.leaveDialog()
    }
    await page.getByTestId('map-menu').click()
    await expectClean(page, 'menu')
  })
}

test('axe finds nothing serious on a phone @phone', async ({ page }) => {
  await new RacePage(page).openAtRest()
  await expectClean(page, 'phone')
})

test('everything can be reached and done with the keyboard alone', async ({ page }) => {
  const race = new RacePage(page)
  await race.open()
  await page.keyboard.press('Space')
  await expect(page.getByTestId('play')).toHaveAccessibleName(/play/i)
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'paused')
  await page.keyboard.press('r')
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
  await expect.poll(() => race.antMoves()).toBe(0)

  await tabTo(page, 'map-menu')
  await page.keyboard.press('Enter')
  const items = page.getByRole('menuitemradio')
  await expect(items.first()).toBeFocused()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(20)

  await tabTo(page, 'stage')
  const walls = await race.walls()
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'Enter']) await page.keyboard.press(key)
  await expect.poll(() => race.walls()).not.toBe(walls)

  await tabTo(page, 'share')
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
  await race.leaveDialog()
  await expect(page.getByTestId('share')).toBeFocused()

  await page.keyboard.press('?')
  await expect(page.getByTestId('help-dialog')).toBeVisible()
  await race.leaveDialog()
  await page.keyboard.press('End')
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal', {
    timeout: 20_000,
  })
})

/** Tab, as often as it takes, until the control has the focus. */
async function tabTo(page: Page, testId: string): Promise<void> {
  for (let presses = 0; presses < 120; presses++) {
    const focused = await page.evaluate(
      () => (document.activeElement as HTMLElement | null)?.dataset.testid ?? '',
    )
    if (focused.startsWith(testId)) return
    await page.keyboard.press('Tab')
  }
  throw new Error(`${testId} cannot be reached with Tab`)
}

test('a manual theme outlives a reload', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  const race = new RacePage(page)
  await race.open()
  await race.menu('theme', 'theme-dark')
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark')
  await page.reload()
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark')
})

test('the page speaks Chinese, too', async ({ page }) => {
  const race = new RacePage(page)
  await race.open()
  await race.menu('language', 'language-zh-CN')
  await expect(page.locator('html')).toHaveAttribute('lang', /^zh/)
  await expect(page.getByTestId('share')).toContainText(/\p{Script=Han}/u)
})
