import { expect, test } from '@playwright/test'
import { RacePage } from './race_page'
import { KNOWN } from './rasters'
import { expectHeights, openAsc, scenarioOf } from './terrain_page'

test.describe('on a terrain', () => {
  test('nothing can be where there is no data, and that is said', async ({ page }) => {
    const race = await openAsc(page)
    await race.drag([[0, 4]])
    await expect(page.getByTestId('toast-warning')).toContainText('not known')
    expect(await race.isWall([0, 4])).toBe(true)
    const { start } = (await scenarioOf(race)).spec
    await page.getByTestId('tool-start').click()
    await race.drag([[0, 3]])
    expect((await scenarioOf(race)).spec.start).toEqual(start)
    await page.getByTestId('tool-wall').click()
    await race.drag([
      [1, 2],
      [3, 2],
    ])
    await expect.poll(() => race.walls()).toBe(6)
    await race.menu('map-menu', 'clear')
    await expect.poll(() => race.walls()).toBe(3)
    await page.getByTestId('map-menu').click()
    await expect(page.getByTestId('invert')).toHaveAttribute('aria-disabled', 'true')
  })

  test('undo and redo bring heights and rules back', async ({ page }) => {
    const race = await openAsc(page)
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('resize-width').fill('4')
    await page.getByTestId('model-slices').click()
    await race.applyRules()
    const cut = await scenarioOf(race)
    expect([cut.spec.width, cut.heights?.length]).toEqual([4, 20])
    expect(cut.spec.terrain?.slices?.levels).toBe(20)
    await page.locator('body').press('Control+z')
    await expectHeights(race, KNOWN)
    expect((await scenarioOf(race)).spec.terrain).toEqual({ vertical_unit: 1, max_slope: 90 })
    await page.locator('body').press('Control+z')
    await expect.poll(async () => (await scenarioOf(race)).heights).toBeNull()
    expect((await scenarioOf(race)).spec.terrain).toBeUndefined()
    await page.locator('body').press('Control+Shift+z')
    await expectHeights(race, KNOWN)
    await page.locator('body').press('Control+Shift+z')
    expect((await scenarioOf(race)).spec.terrain?.slices).toEqual(cut.spec.terrain?.slices)
  })

  test('the rules of slices are set, checked and kept', async ({ page }) => {
    const race = await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('model-slices').click()
    await page.getByTestId('slices-levels').fill('300')
    await page.getByTestId('slices-levels').press('Tab')
    await expect(page.getByTestId('slices-levels')).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByTestId('resize')).toBeDisabled()
    for (const [field, value] of [
      ['slices-levels', 9],
      ['slices-level', 5],
      ['slices-max_climb', 3],
      ['slices-max_aside', 1],
      ['slices-start_level', 8],
      ['slices-goal_level', 9],
    ] as const) {
      await page.getByTestId(field).fill(String(value))
      await page.getByTestId(field).press('Tab')
    }
    await page.getByTestId('measure-length').click()
    await race.applyRules()
    await expect(page.getByTestId('terrain-model')).toContainText('9 levels of 5 m')
    const { spec } = await scenarioOf(race)
    expect(spec.terrain).toEqual({
      vertical_unit: 1,
      slices: {
        level: 5,
        levels: 9,
        max_aside: 1,
        max_climb: 3,
        start_level: 8,
        goal_level: 9,
        measure: 'length',
      },
    })
    // 35 m of ground under levels up to 20 m: no place for an end there.
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('slices-level').fill('1')
    await page.getByTestId('slices-level').press('Tab')
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('no-place')).toBeVisible()
  })

  test('levels below the ground are lifted, and that is said', async ({ page }) => {
    const race = await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('model-slices').click()
    for (const [field, value] of [
      ['slices-level', 5],
      ['slices-levels', 9],
      ['slices-start_level', 1],
      ['slices-goal_level', 9],
    ] as const) {
      await page.getByTestId(field).fill(String(value))
      await page.getByTestId(field).press('Tab')
    }
    await race.applyRules()
    // The start lies on 10 m: levels of 5 m begin at the second there.
    await expect(page.getByTestId('toast-warning')).toContainText(
      'start at level 2, goal at level 9',
    )
    await expect(page.getByTestId('terrain-model')).toHaveText('By slices, 9 levels of 5 m, 2 → 9')
    expect((await scenarioOf(race)).spec.terrain?.slices?.start_level).toBe(2)
    await expect(page.getByTestId('panel-1').getByRole('alert')).toBeVisible()
    await expect(page.locator('.plot-hint')).toContainText('Cost by iteration')
  })

  test('a limit of slope is seen beside the moves', async ({ page }) => {
    await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('max-slope').fill('12.5')
    await page.getByTestId('max-slope').press('Tab')
    await new RacePage(page).applyRules()
    await expect(page.getByTestId('terrain-model')).toHaveText(
      'On the surface, 8 moves, up to 12.5°',
    )
  })

  test('planners that do not know the ground are told apart, and a panel says what to do', async ({
    page,
  }) => {
    const race = await openAsc(page)
    const option = (id: string) => page.getByTestId('planner-1').locator(`option[value="${id}"]`)
    await expect(option('theta-star')).toBeDisabled()
    await expect(option('ant-system')).toBeEnabled()
    await page.getByTestId('add-panel').click()
    await expect(page.getByTestId('add-theta-star')).toHaveAttribute('aria-disabled', 'true')
    await expect(page.getByTestId('add-theta-star')).toContainText('surface')
    await page.keyboard.press('Escape')
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('model-slices').click()
    await race.applyRules()
    const trouble = page.getByTestId('panel-1').getByRole('alert')
    await expect(trouble).toContainText('does not plan by slices')
    await trouble.getByRole('button').click()
    await expect(trouble).toBeHidden()
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('model-surface').click()
    await page.getByTestId('movement').selectOption('16-both-free')
    await race.applyRules()
    await expect(page.getByTestId('terrain-model')).toContainText('16 moves')
    await expect(option('ant-system')).toBeDisabled()
    await expect(option('astar')).toBeEnabled()
  })

  test('16 moves go on a plane, too', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('planner-1').selectOption('astar')
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('movement').selectOption('16-both-free')
    await race.applyRules()
    await race.ready()
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    await expect(page.getByTestId('gap-2')).toHaveAttribute('data-gap', '0')
  })

  test('lengths are given in cells and metres, with climb, descent and slope', async ({ page }) => {
    await openAsc(page)
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    const value = async (id: string) =>
      Number(await page.getByTestId(`metric-${id}-2`).getAttribute('data-value'))
    await expect.poll(() => value('climb')).toBeGreaterThan(0)
    const length = await value('length')
    await expect(page.getByTestId('metric-length-2')).toHaveText((10 * length).toFixed(2))
    await expect(page.getByTestId('metric-lengthMetres-2')).toBeHidden()
    const race = new RacePage(page)
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('lengths-cells').click()
    await race.applyRules()
    await expect(page.getByTestId('metric-length-2')).toHaveText(length.toFixed(2))
    expect(await value('lengthMetres')).toBeCloseTo(10 * length, 6)
    const { heights, spec } = await scenarioOf(race)
    const at = ([x, y]: [number, number]) => heights?.[y * spec.width + x] ?? Number.NaN
    const rise = at(spec.goals[0]?.at ?? spec.start) - at(spec.start)
    expect((await value('climb')) - (await value('descent'))).toBeCloseTo(rise, 6)
    expect(await value('steepest')).toBeLessThan(90)
    await expect(page.getByTestId('metric-levelCost-2')).toBeHidden()
  })
})
