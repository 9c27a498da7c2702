import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

/** Opens the difference, and waits until there is one. */
async function open(page: Page): Promise<void> {
  await page.getByTestId('compare-trails').click()
  await expect(page.getByTestId('difference')).toBeVisible()
  await expect(page.getByTestId('difference-normalised')).toContainText('A ')
  await expect(page.getByTestId('difference-empty')).toBeHidden()
}

test.describe('the difference of two trails', () => {
  test('is offered for two colonies, follows them, and tells both values of a cell', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await expect(
      page.getByTestId('planner-1').locator('option[value="ant-colony-system"]'),
    ).toBeAttached()
    // It comes with the same part of the page.
    await expect(page.getByTestId('scrubber')).toBeVisible()
    await expect(page.getByTestId('compare-trails')).toBeHidden()
    await page.getByTestId('planner-2').selectOption('ant-colony-system')
    await race.ready()
    await open(page)
    const view = page.getByTestId('difference')
    await expect(view.getByTestId('difference-a')).toContainText('A: Ant System')
    await expect(view.getByTestId('difference-b')).toContainText('B: Ant Colony System')

    const canvas = page.getByTestId('stage-difference')
    const values = view.getByTestId('difference-values')
    // Trails are asked for a few times a second: those on show may be of iterations before.
    const of = (iterations: string) => expect(values).toHaveAttribute('data-iterations', iterations)
    await of('0,0')
    await race.frame()
    const before = await canvas.screenshot()
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    await of('5,5')
    await expect.poll(async () => before.equals(await canvas.screenshot())).toBe(false)
    await expect(view.getByTestId('difference-normalised')).toContainText(
      /A [\d.E-]+–[\d.E-]+, B [\d.E-]+–[\d.E-]+/,
    )
    await canvas.focus()
    await page.keyboard.press('ArrowRight')
    const { start } = (await race.session()).scenario.spec
    await expect(values).toContainText(`(${start[0]}, ${start[1]})`)
    await expect(values).toContainText(/A .+ · B .+ · difference [+−-]?\d/)

    // The scrubber takes it along; exchanging A and B turns the sign.
    const now = await values.innerText()
    await page.evaluate(() => window.formicarium.look(1))
    await of('1,1')
    await expect.poll(() => values.innerText()).not.toBe(now)
    await page.getByTestId('back-to-now').click()
    await of('5,5')
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
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('add-panel', 'add-ant-system')
    await race.ready()
    await open(page)
    await page.getByTestId('remove-3').click()
    await expect(page.getByTestId('difference-empty')).toContainText('two planners')
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      const race = new RacePage(page)
      await race.openAtRest()
      await race.menu('add-panel', 'add-ant-system')
      await race.ready()
      await open(page)
      await expectClean(page, 'the difference of two trails')
    })
  }

  test('fits on a phone @phone', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('add-panel', 'add-ant-system')
    await race.ready()
    await page.getByTestId('compare-trails').tap()
    await expect(page.getByTestId('difference')).toBeVisible()
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth)
    expect(wide).toBe(false)
  })
})
