import { expect, test } from '@playwright/test'
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
  await new RacePage(page).open()
  for (const testId of ['play', 'step-move', 'reset', 'share', 'map-menu', 'undo', 'tool-wall']) {
    const box = await page.getByTestId(testId).boundingBox()
    expect(Math.min(box?.width ?? 0, box?.height ?? 0), testId).toBeGreaterThanOrEqual(32)
  }
})
