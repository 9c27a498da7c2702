/** Readings of a paper as a switch: on a panel of the race, and on an entry of a comparison. */
import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { RacePage } from './race_page'

/** The map of the fire paper, with the parameters of its first panel. */
async function fire(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-paper-fire')
  await page.getByTestId('parameters-1').click()
  await expect(page.getByTestId('reading')).toBeVisible()
  return race
}

const setup = async (race: RacePage) => (await race.session()).panels[0]

test.describe('readings of a panel', () => {
  test('one press sets the preset, and is one step to undo', async ({ page }) => {
    const race = await fire(page)
    const group = page.getByRole('radiogroup', { name: 'Reading', exact: true })
    await expect(group.getByRole('radio')).toHaveCount(3)
    await expect(group.getByRole('radio', { name: 'as we read it' })).toBeChecked()
    await expect(page.getByTestId('reading-meaning')).toContainText('repaired')
    const before = await setup(race)
    await page.getByTestId('reading-printed').check()
    await expect(group.getByRole('radio', { name: 'as printed' })).toBeChecked()
    await expect(page.getByTestId('preset')).toHaveValue('printed')
    await expect(page.getByTestId('panel-1')).toHaveAccessibleName(/Multi-fire ACO · printed$/)
    await expect(page.getByTestId('reading-meaning')).toContainText('ρ = 0.3 stays (eq. 4)')
    expect((await setup(race))?.params.reading).toBe('printed')
    await page.keyboard.press('Control+z')
    await expect(page.getByTestId('preset')).toHaveValue('paper')
    expect(await setup(race)).toEqual(before)
    await page.keyboard.press('Control+Shift+z')
    await expect(page.getByTestId('preset')).toHaveValue('printed')
  })

  test('the group is operated by keys, and own values are no reading', async ({ page }) => {
    const race = await fire(page)
    await page.getByTestId('reading-as-read').focus()
    await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('reading-second-reading')).toBeChecked()
    await expect(page.getByTestId('reading-second-reading')).toBeFocused()
    await expect(page.getByTestId('preset')).toHaveValue('second-reading')
    await page.getByTestId('param-ants').fill('7')
    await page.getByTestId('param-ants').press('Enter')
    await expect(page.getByTestId('reading').locator(':checked')).toHaveCount(0)
    await expect(page.getByTestId('reading-meaning')).toHaveText(
      'Own values: no reading as a whole.',
    )
    // Undo of the switch brings back what stood before it, whatever was changed since.
    await page.getByTestId('map-menu').focus()
    await page.keyboard.press('Control+z')
    await expect(page.getByTestId('reading-as-read')).toBeChecked()
    expect((await setup(race))?.params.ants).toBeUndefined()
  })

  test('only those that the planner has are offered', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('parameters-1').click()
    await expect(page.getByTestId('preset')).toBeVisible()
    await expect(page.getByTestId('reading')).toHaveCount(0)
    await race.menu('map-menu', 'gallery-paper-criss-cross')
    await page.getByTestId('add-panel').click()
    await page.getByTestId('add-pso-aco').click()
    await expect(page.getByTestId('reading').getByRole('radio')).toHaveCount(2)
    await expect(page.getByTestId('reading-as-read')).toBeChecked()
    await expect(page.getByTestId('reading-meaning')).toContainText('The defaults')
  })

  test('in Chinese, and without an objection by axe', async ({ page }) => {
    await fire(page)
    const { violations } = await new AxeBuilder({ page }).include('.parameters').analyze()
    expect(violations).toEqual([])
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    const group = page.getByRole('radiogroup', { name: '读法', exact: true })
    await expect(group.locator('label')).toHaveText(['按印刷公式', '按我们的理解', '第二种读法'])
  })

  test('on a phone its targets are large @phone', async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 844 })
    await fire(page)
    for (const label of await page.getByTestId('reading').locator('label').all()) {
      const box = await label.boundingBox()
      expect(box?.height).toBeGreaterThanOrEqual(40)
      expect(box?.width).toBeGreaterThanOrEqual(40)
    }
    const wide = await page.evaluate(() => document.documentElement.scrollWidth)
    expect(wide).toBeLessThanOrEqual(390)
  })
})

test('an entry of a comparison has the same switch', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('ant-system', 'ship')
  await expect(comparison.entry(1).getByTestId('entry-reading')).toHaveCount(0)
  const ship = comparison.entry(2)
  await expect(ship.getByTestId('entry-reading-as-read')).toBeChecked()
  await ship.getByTestId('entry-reading-second-reading').check()
  await expect(ship.getByTestId('entry-reading-second-reading')).toBeChecked()
  await expect(ship.getByTestId('entry-reading-meaning')).toContainText('ρ = 0.8')
  await ship.locator('summary').click()
  await expect(ship.getByTestId('entry-preset')).toHaveValue('second-reading')
  await ship.getByTestId('entry-preset').selectOption('cells')
  await expect(ship.getByTestId('entry-reading').locator(':checked')).toHaveCount(0)
  const { violations } = await new AxeBuilder({ page }).include('.draft-entry').analyze()
  expect(violations).toEqual([])
})
