import AxeBuilder from '@axe-core/playwright'
import { expect, test } from '@playwright/test'
import { Lab } from './lab'

test.describe('the difference of two trails', () => {
  test('is offered for two colonies, follows them, and tells both values of a cell', async ({
    page,
  }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await expect(
      page.getByTestId('planner-1').locator('option[value="ant-colony-system"]'),
    ).toBeAttached()
    await expect(page.getByTestId('compare-trails')).toBeHidden()
    await page.getByTestId('planner-2').selectOption('ant-colony-system')
    await lab.ready()
    await page.getByTestId('compare-trails').click()
    const view = page.getByTestId('difference')
    await expect(view).toBeVisible()
    await expect(view.getByTestId('difference-a')).toContainText('A: Ant System')
    await expect(view.getByTestId('difference-b')).toContainText('B: Ant Colony System')

    const canvas = page.getByTestId('stage-difference')
    const before = await canvas.screenshot()
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    await expect.poll(async () => before.equals(await canvas.screenshot())).toBe(false)
    await expect(view.getByTestId('difference-normalised')).toContainText(
      /A [\d.E-]+–[\d.E-]+, B [\d.E-]+–[\d.E-]+/,
    )
    await canvas.focus()
    await page.keyboard.press('ArrowRight')
    const values = view.getByTestId('difference-values')
    const { start } = (await lab.session()).scenario.spec
    await expect(values).toContainText(`(${start[0]}, ${start[1]})`)
    await expect(values).toContainText(/A .+ · B .+ · difference [+−-]?\d/)

    // The scrubber takes it along; exchanging A and B turns the sign.
    const now = await values.innerText()
    await page.evaluate(() => window.formicarium.look(1))
    await expect.poll(() => values.innerText()).not.toBe(now)
    await page.getByTestId('back-to-now').click()
    await expect.poll(() => values.innerText()).toBe(now)
    const b = await view.getByTestId('difference-b').inputValue()
    await view.getByTestId('difference-a').selectOption(b)
    await expect(view.getByTestId('difference-a')).toHaveValue(b)
    const number = (text: string) => text.replace('−', '-').match(/difference ([+-]?[\d.]+)/)?.[1]
    await expect
      .poll(async () => Number(number(await values.innerText())) + Number(number(now)))
      .toBeCloseTo(0, 6)
    await page.getByTestId('close-difference').click()
    await expect(view).toBeHidden()
  })

  test('says so when one of the two has gone', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('add-panel', 'add-ant-system')
    await lab.ready()
    await page.getByTestId('compare-trails').click()
    await expect(page.getByTestId('difference-empty')).toBeHidden()
    await page.getByTestId('remove-3').click()
    await expect(page.getByTestId('difference-empty')).toContainText('two planners')
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      const lab = new Lab(page)
      await lab.openAtRest()
      await lab.menu('add-panel', 'add-ant-system')
      await lab.ready()
      await page.getByTestId('compare-trails').click()
      await expect(page.getByTestId('difference-empty')).toBeHidden()
      const { violations } = await new AxeBuilder({ page }).analyze()
      expect(
        violations.filter(({ impact }) => impact === 'serious' || impact === 'critical'),
      ).toEqual([])
    })
  }

  test('fits on a phone @phone', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('add-panel', 'add-ant-system')
    await lab.ready()
    await page.getByTestId('compare-trails').tap()
    await expect(page.getByTestId('difference')).toBeVisible()
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth)
    expect(wide).toBe(false)
  })
})
