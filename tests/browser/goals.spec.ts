import { expect, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import type { Session } from '../../www/src/model/session'
import { expectClean } from './axe'
import { freshRace, RacePage } from './race_page'

/** The open field: 40 × 25 cells, start (4, 19), goal (35, 5). */
async function openField(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  return race
}

async function click(race: RacePage, cell: Cell): Promise<void> {
  const { x, y } = await race.pointOf(cell)
  await race.page.mouse.click(x, y)
  await race.frame()
}

const goals = async (race: RacePage) => (await race.session()).scenario.spec.goals
const places = async (race: RacePage) => (await goals(race)).map(({ at }) => at.join())

/** The open field with these goals, and these planners. */
async function load(race: RacePage, at: Cell[], planners: string[]): Promise<void> {
  const session = await race.session()
  const [goal] = session.scenario.spec.goals
  await race.page.evaluate(
    ({ cells, session, ...rest }) =>
      window.formicarium.load({
        ...session,
        ...rest,
        scenario: { ...session.scenario, ...rest.scenario, cells: Uint8Array.from(cells) },
      }),
    {
      session: { ...session, scenario: { ...session.scenario, cells: new Uint8Array() } },
      cells: Array.from(session.scenario.cells),
      panels: planners.map((planner) => ({ planner, preset: null, params: {}, result: null })),
      scenario: {
        spec: {
          ...session.scenario.spec,
          goals: at.map((place, i) => ({ ...goal, at: place, name: `G${i + 1}` })),
        },
      },
    } as unknown as { cells: number[]; session: Session; scenario: Session['scenario'] },
  )
  await race.ready()
}

test.describe('several goals', () => {
  test('where no shortest tour can be asked for, the page says so and why', async ({ page }) => {
    // The part of the engine that knows tours does not come.
    await page.route(/whole\.worker/, (route) => route.abort())
    const race = await openField(page)
    await page.keyboard.press('a')
    await click(race, [10, 4])
    await expect(page.getByTestId('optimum')).toHaveText(
      'Shortest tour: none, for the reason beside it',
    )
    await expect(page.locator('.race-strip')).toContainText('could not be fetched')
  })

  test('the tool adds them, any can be dragged, undo takes them back', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('a')
    await expect(page.getByTestId('tool-add-goal')).toHaveAttribute('aria-pressed', 'true')
    await click(race, [10, 4])
    await expect(page.getByTestId('goals')).toBeVisible()
    await click(race, [20, 20])
    expect(await places(race)).toEqual(['35,5', '10,4', '20,20'])
    expect((await goals(race)).map(({ name }) => name)).toEqual(['A', 'B', 'C'])
    await expect(page.getByTestId('goal-count')).toHaveText('3 goals')

    await page.getByTestId('tool-wall').click()
    await race.drag([
      [10, 4],
      [12, 8],
    ])
    await race.drag([
      [20, 20],
      [4, 19],
    ])
    const [, second, third] = await goals(race)
    expect(second?.at).toEqual([12, 8])
    // Never onto the start.
    expect(third?.at).toEqual([20, 20])
    expect(await race.walls()).toBe(0)

    await page.getByTestId('tool-goal').click()
    await expect(page.getByTestId('tool-goal')).toHaveAccessibleName('Move goal C')
    await click(race, [30, 20])
    expect((await places(race))[2]).toBe('30,20')

    for (let step = 0; step < 4; step++) await page.keyboard.press('Control+z')
    expect(await places(race)).toEqual(['35,5'])
    await expect(page.getByTestId('goals')).toBeHidden()
    await page.keyboard.press('Control+Shift+z')
    expect(await places(race)).toEqual(['35,5', '10,4'])
  })

  test('the keyboard adds, moves and removes them, and says so', async ({ page }) => {
    const race = await openField(page)
    const said = page.getByTestId('announcement')
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('Control+ArrowRight')
    await page.keyboard.press('a')
    await page.keyboard.press('Enter')
    expect(await places(race)).toEqual(['35,5', '14,19'])
    await expect(said).toContainText('goal B')

    await page.keyboard.press('g')
    await page.keyboard.press('Enter')
    await expect(said).toContainText('goal B taken up')
    await page.keyboard.press('ArrowUp')
    await page.keyboard.press('Enter')
    expect(await places(race)).toEqual(['35,5', '14,18'])

    await page.keyboard.press('Delete')
    await expect(said).toContainText('Goal B removed')
    expect(await places(race)).toEqual(['35,5'])
    await page.keyboard.press('Control+ArrowRight')
    await page.keyboard.press('Control+ArrowRight')
    await page.keyboard.press('ArrowRight')
    for (let up = 0; up < 13; up++) await page.keyboard.press('ArrowUp')
    await page.keyboard.press('Delete')
    await expect(said).toContainText('only one')
    expect(await places(race)).toEqual(['35,5'])
  })

  test('the table: weights, places and names; a name leaves the runs alone', async ({ page }) => {
    const race = await openField(page)
    await load(
      race,
      [
        [10, 4],
        [30, 20],
      ],
      ['fire'],
    )
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    await page.getByTestId('goal-name-1').fill('Galley')
    await page.getByTestId('goal-name-1').press('Enter')
    expect((await goals(race))[0]?.name).toBe('Galley')
    expect((await race.result(1)).summary?.iteration).toBe(2)
    await expect(page.getByTestId('metric-order-1')).toContainText('Galley')
    await page.getByTestId('undo').click()
    expect((await goals(race))[0]?.name).toBe('G1')
    expect((await race.result(1)).summary?.iteration).toBe(2)

    await page.getByTestId('goal-danger-1').fill('4')
    await page.getByTestId('goal-danger-1').press('Enter')
    await expect(page.getByTestId('goal-weight-1')).toHaveText('0.250')
    await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(0)

    const area = page.getByTestId('goal-area-2')
    await area.fill('-1')
    await area.press('Enter')
    const alert = page.getByTestId('goals').getByRole('alert')
    await expect(alert).toContainText('Area = -1')
    await expect(area).toHaveAttribute('aria-invalid', 'true')
    expect((await goals(race))[1]?.area).toBe(1)
    await area.press('Escape')
    await expect(area).toHaveValue('1')
    await expect(alert).toBeHidden()

    const place = page.getByTestId('goal-place-2')
    for (const [text, words] of [
      ['50, 3', 'outside'],
      ['10, 4', 'two goals'],
      ['4, 19', 'start'],
      ['there', 'no place'],
    ] as const) {
      await place.fill(text)
      await place.press('Enter')
      await expect(alert).toContainText(words, { ignoreCase: true })
    }
    await place.fill('31, 7')
    await place.press('Enter')
    expect(await places(race)).toEqual(['10,4', '31,7'])
    await expect(alert).toBeHidden()

    await page.getByTestId('goal-remove-1').click()
    expect(await places(race)).toEqual(['31,7'])
  })

  test('one goal has its table on demand', async ({ page }) => {
    await openField(page)
    await new RacePage(page).menu('map-menu', 'open-goals')
    await expect(page.getByTestId('goals')).toBeInViewport()
    await expect(page.getByTestId('goal-remove-1')).toBeDisabled()
    await page.getByTestId('goals-add').click()
    await expect(page.getByTestId('tool-add-goal')).toHaveAttribute('aria-pressed', 'true')
  })

  test('planners for one goal say so in place, and the others run', async ({ page }) => {
    const race = await openField(page)
    await page.getByTestId('add-panel').click()
    await page.getByTestId('add-fire').click()
    await race.ready()
    await page.keyboard.press('a')
    await click(race, [10, 4])
    await expect(page.getByTestId('status-1')).toHaveAttribute('data-status', 'refused')
    await expect(page.getByTestId('panel-1').getByRole('alert')).toContainText('2 goals')
    await page.getByTestId('step-iteration').click()
    await expect.poll(async () => (await race.result(3)).summary?.iteration).toBe(1)
    // The map is drawn on all the same, and the way out is one press away.
    await page.keyboard.press('w')
    const before = await race.picture()
    await race.drag([
      [20, 12],
      [20, 16],
    ])
    // Where the pointer is, there is a mark.
    await page.mouse.move(0, 0)
    await expect.poll(async () => before.equals(await race.picture())).toBe(false)
    await page.getByTestId('panel-2').getByRole('button', { name: 'Use Exact tour' }).click()
    await expect(page.getByTestId('planner-2')).toHaveValue('tour-exact')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'ready')

    await page.getByTestId('add-panel').click()
    const astar = page.getByTestId('add-astar')
    await expect(astar).toHaveAttribute('aria-disabled', 'true')
    await expect(astar).toContainText('Reaches one goal; this map has 2')
    await astar.click({ force: true })
    await expect(page.getByTestId('panel-4')).toBeHidden()
    await page.getByTestId('add-tour-exact').click()
    await expect(page.getByTestId('panel-4')).toBeVisible()
    await expect(page.getByTestId('planner-4').locator('option[value="dijkstra"]')).toBeDisabled()
  })

  test('another map and another size keep the goals with their names', async ({ page }) => {
    const race = await openField(page)
    await load(
      race,
      [
        [10, 4],
        [30, 20],
        [35, 5],
      ],
      ['fire'],
    )
    await race.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-maze').click()
    await page.getByTestId('generate').click()
    await expect.poll(() => race.walls()).toBeGreaterThan(0)
    expect((await goals(race)).map(({ name }) => name)).toEqual(['G1', 'G2', 'G3'])
    for (const at of (await goals(race)).map((goal) => goal.at)) {
      expect(await race.isWall(at)).toBe(false)
    }
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /^[\d.]+$/)
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('resize-width').fill('6')
    await page.getByTestId('resize-height').fill('6')
    await race.applyRules()
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(6)
    const { start } = (await race.session()).scenario.spec
    expect(new Set([...(await places(race)), start.join()]).size).toBe(4)
  })

  test('links carry names and weights, and the tour is verified', async ({ page, browser }) => {
    const race = await openField(page)
    await load(
      race,
      [
        [10, 4],
        [30, 20],
      ],
      ['fire', 'tour-exact'],
    )
    await page.getByTestId('goal-strength-2').fill('2.5')
    await page.getByTestId('goal-strength-2').press('Enter')
    await race.ready()
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    const other = await freshRace(browser, await race.shareLink())
    expect(await goals(other)).toEqual(await goals(race))
    for (const place of [1, 2]) {
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
        { timeout: 30_000 },
      )
    }
    await other.page.reload()
    await other.ready()
    expect(await goals(other)).toEqual(await goals(race))
    await other.page.context().close()
  })
})

test.describe('tours', () => {
  test('order, legs and weights are shown beside what they are compared with', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-fire')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await race.ready()
    await page.evaluate(() => window.formicarium.run())
    const [ants, , exact] = await race.results()
    const tour = ants?.summary?.tour
    if (!tour) throw new Error('no tour')
    expect([...tour.order].sort()).toEqual([0, 1, 2, 3])
    const names = ['A', 'B', 'C', 'D']
    await page.getByTestId('all-metrics').click()
    await expect(page.getByTestId('metric-order-1')).toHaveText(
      tour.order.map((goal) => names[goal]).join(' → '),
    )
    await expect(page.getByTestId('metric-plannedWeight-1')).toHaveText(
      tour.planned_weight.toFixed(2),
    )
    await expect(page.getByTestId('metric-walkedWeight-1')).toHaveText(
      (tour.walked_weight ?? 0).toFixed(2),
    )
    // The paper weighs its tours: the exact planner proves the lightest, and the gap is taken from it.
    const best = exact?.summary?.value ?? Number.NaN
    await expect(page.getByTestId('metric-comparedWith-1')).toContainText(
      `lightest tour ${best.toFixed(2)}`,
    )
    await expect(page.getByTestId('status-3')).toHaveText('Proven best')
    await expect
      .poll(async () => Number(await page.getByTestId('gap-1').getAttribute('data-gap')))
      .toBeCloseTo((ants?.summary?.value ?? 0) / best - 1, 9)
    await expect(page.getByTestId('gap-3')).toHaveAttribute('data-gap', '0')

    await page.getByTestId('parameters-1').click()
    const legs = page.getByTestId('legs')
    await expect(legs.locator('tbody tr')).toHaveCount(5)
    await expect(legs.locator('tbody tr').first()).toContainText(
      `start → ${names[tour.order[0] ?? 0]}`,
    )
    await expect(legs.locator('tbody tr').last()).toContainText(
      (ants?.summary?.metrics?.length ?? 0).toFixed(2),
    )
  })

  test('beyond what can be proven the best of the panels stands in, and says so', async ({
    page,
  }) => {
    const race = await openField(page)
    const spread = Array.from(
      { length: 60 },
      (_, i): Cell => [((17 * i + 2) % 39) + 1, ((5 * i * i + 3 * i) % 24) + 1],
    )
    const places = new Map(spread.map((cell) => [cell.join(), cell]))
    await load(race, [...places.values()], ['fire', 'custom'])
    const first = page.getByTestId('metric-comparedWith-1')
    const second = page.getByTestId('metric-comparedWith-2')
    await expect(first).toContainText('–')
    await expect(first).toContainText('Nothing is proven for a question of this size')
    await expect(page.getByTestId('optimum')).toContainText('not known at this size')
    await page.evaluate(() => window.formicarium.run({ iterations: 1 }))
    const values = (await race.results()).map(({ summary }) => summary?.value ?? Number.NaN)
    for (const cell of [first, second]) {
      await expect(cell).toContainText(Math.min(...values).toFixed(2))
      await expect(cell).toContainText('not proven')
    }
    const best = values.indexOf(Math.min(...values)) + 1
    await expect(page.getByTestId(`gap-${best}`)).toContainText('the best known (not proven)')
  })

  test('more goals than dynamic programming orders are compared with what is proven', async ({
    page,
  }) => {
    const race = await openField(page)
    await load(
      race,
      Array.from({ length: 17 }, (_, i): Cell => [2 * i + 1, 2]),
      ['formica', 'fire'],
    )
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /^[\d.]+$/)
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-1')).toHaveAttribute('data-status', 'optimal')
    await expect(page.getByTestId('gap-1')).toHaveAttribute('data-gap', '0')
    await expect(page.getByTestId('metric-comparedWith-1')).not.toContainText('not proven')
  })

  test('a goal out of reach is said', async ({ page }) => {
    const race = await openField(page)
    await load(
      race,
      [
        [10, 4],
        [39, 0],
      ],
      ['fire'],
    )
    await page.keyboard.press('w')
    await race.drag([
      [38, 0],
      [38, 1],
      [39, 1],
    ])
    await expect(page.getByTestId('optimum')).toContainText('cannot be reached')
  })
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious with goals and their table (${scheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme })
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-fire')
    await expect(page.getByTestId('goals')).toBeVisible()
    await page.evaluate(() => window.formicarium.run({ iterations: 1 }))
    await page.getByTestId('goal-area-2').fill('-1')
    await page.getByTestId('goal-area-2').press('Enter')
    await expect(page.getByTestId('goals').getByRole('alert')).toBeVisible()
    await expect(page.getByTestId('legs')).toBeVisible()
    await expectClean(page, 'the table of goals')
    await page.getByTestId('add-panel').click()
    await expectClean(page, 'the table of goals')
  })
}

test('on a phone goals are added by touch, and the table fits @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('tool-add-goal').tap()
  // A tap becomes a click only after it has been told apart from other gestures.
  await expect(page.getByTestId('tool-add-goal')).toHaveAttribute('aria-pressed', 'true')
  const { x, y } = await race.pointOf([8, 2])
  await page.touchscreen.tap(x, y)
  await expect.poll(() => places(race)).toEqual(['32,10', '8,2'])
  await page.getByTestId('goal-count').tap()
  await expect(page.getByTestId('goals')).toBeInViewport()
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
  expect(overflow).toBeLessThanOrEqual(0)
  const inside = await page
    .getByTestId('goals')
    .locator('.table-scroll')
    .evaluate((table) => table.scrollWidth - table.clientWidth)
  expect(inside).toBeLessThanOrEqual(0)
  await page.getByTestId('goal-remove-2').tap()
  await expect.poll(() => places(race)).toEqual(['32,10'])
})
