import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

const moves = (page: Page) => page.getByTestId('move')

/** Sum of the probabilities on show. */
async function sum(page: Page): Promise<number> {
  const all = await moves(page).evaluateAll((rows) =>
    rows.map((row) => Number((row as HTMLElement).dataset.probability)),
  )
  return all.reduce((total, share) => total + share, 0)
}

test.describe('the moves of a cell', () => {
  test('stand beside it with their probabilities, and follow the run into its past', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.locator('body').press('i')
    await expect(page.getByTestId('tool-inspect')).toHaveAttribute('aria-pressed', 'true')
    const { start } = (await race.session()).scenario.spec
    const walls = await race.walls()
    const at = await race.pointOf(start)
    await page.mouse.click(at.x, at.y)
    await expect(page.getByTestId('moves-card')).toContainText(`(${start[0]}, ${start[1]})`)
    await expect(moves(page).first()).toBeVisible()
    await expect(page.getByTestId('move-arrows').locator('.arrow')).toHaveCount(
      await moves(page).count(),
    )
    expect(await sum(page)).toBeCloseTo(1, 9)
    await expect(page.getByTestId('moves-card')).toContainText('before its first iteration')
    const fresh = await page.getByTestId('moves').innerText()

    await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
    await expect.poll(() => page.getByTestId('moves').innerText()).not.toBe(fresh)
    await expect(page.getByTestId('moves-card')).toContainText('after iteration 6')
    expect(await sum(page)).toBeCloseTo(1, 9)
    await page.evaluate(() => window.formicarium.look(0))
    await expect.poll(() => page.getByTestId('moves').innerText()).toBe(fresh)

    // Nothing was drawn by looking.
    expect(await race.walls()).toBe(walls)
    expect((await race.session()).scenario.spec.start).toEqual(start)
  })

  test('by keyboard: Enter on the cursor, Esc closes and gives the focus back', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const { start } = (await race.session()).scenario.spec
    await page.locator('body').press('i')
    await race.stage().focus()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('moves-card')).toContainText(`(${start[0]}, ${start[1]})`)
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('moves-card')).toContainText(`(${start[0] + 1}, ${start[1]})`)
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('moves-card')).toBeHidden()
    await expect(race.stage()).toBeFocused()
    await expect(page.getByTestId('tool-inspect')).toHaveAttribute('aria-pressed', 'true')
  })

  test('a search, a wall and the goal say why there are none', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.locator('body').press('i')
    const { spec, cells } = (await race.session()).scenario
    const goal = spec.goals[0]?.at ?? [0, 0]
    const search = await race.pointOf(spec.start, 2)
    await page.mouse.click(search.x, search.y)
    await expect(page.getByTestId('no-moves')).toContainText('no ants')
    const end = await race.pointOf(goal)
    await page.mouse.click(end.x, end.y)
    await expect(page.getByTestId('no-moves')).toContainText('ants stop here')
    const wall = cells.indexOf(1)
    const blocked = await race.pointOf([wall % spec.width, Math.floor(wall / spec.width)])
    await page.mouse.click(blocked.x, blocked.y)
    await expect(page.getByTestId('no-moves')).toContainText('wall')
    await page.getByTestId('tool-wall').click()
    await expect(page.getByTestId('moves-card')).toBeHidden()
  })

  test('two goals have a choice for each leg', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('planner-1').selectOption('fire')
    await race.ready()
    await page.getByTestId('tool-add-goal').click()
    const { spec } = (await race.session()).scenario
    const at = await race.pointOf([Math.floor(spec.width / 2), 1])
    await page.mouse.click(at.x, at.y)
    await expect.poll(async () => (await race.session()).scenario.spec.goals.length).toBe(2)
    await expect.poll(async () => (await race.result(1)).summary !== null).toBe(true)
    await page.getByTestId('step-iteration').click()
    await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(1)
    await expect(page.getByTestId('goals')).toBeVisible()
    await page.getByTestId('tool-inspect').click()
    const from = await race.pointOf(spec.start)
    await page.mouse.click(from.x, from.y)
    await expect(page.getByTestId('colony-1')).toBeVisible()
    expect(await sum(page)).toBeCloseTo(1, 9)
    await page.getByTestId('colony-1').click()
    await expect(page.getByTestId('colony-1')).toHaveAttribute('aria-pressed', 'true')
    expect(await sum(page)).toBeCloseTo(1, 9)
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      const race = new RacePage(page)
      await race.openAtRest()
      await page.locator('body').press('i')
      await race.stage().focus()
      await page.keyboard.press('Enter')
      await expect(moves(page).first()).toBeVisible()
      await expectClean(page, 'a cell of a panel')
    })
  }

  test('on a phone the card leaves half of the map free @phone', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('tool-inspect').tap()
    // A tap becomes a click only after it has been told apart from other gestures.
    await expect(page.getByTestId('tool-inspect')).toHaveAttribute('aria-pressed', 'true')
    const { start } = (await race.session()).scenario.spec
    const at = await race.pointOf(start)
    await page.touchscreen.tap(at.x, at.y)
    await expect(moves(page).first()).toBeVisible()
    const card = await page.getByTestId('moves-card').boundingBox()
    const stage = await race.stage().boundingBox()
    expect((card?.height ?? 0) / (stage?.height ?? 1)).toBeLessThan(0.7)
    await page.getByTestId('close-moves').tap()
    await expect(page.getByTestId('moves-card')).toBeHidden()
  })
})
