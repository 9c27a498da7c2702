/** Which view was opened first makes no difference: every control of Watch and Compare is there, and does what it does. */
import { type Browser, expect, type Page, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { RacePage } from './race_page'

type View = 'race' | 'lab'

/** A fresh browser that opened `first`, then went to `then`. */
async function opened(browser: Browser, first: View, then: View): Promise<Page> {
  const page = await (
    await browser.newContext({ viewport: { width: 1440, height: 900 } })
  ).newPage()
  await page.goto(first === 'lab' ? './#lab' : './')
  if (first !== then) {
    const shown = first === 'lab' ? 'builder' : 'play'
    await expect(page.getByTestId(shown)).toBeVisible()
    await page.getByTestId(`view-${then}`).click()
  }
  if (then === 'lab') await new ComparisonPage(page).ready()
  else {
    await new RacePage(page).ready()
    await page.getByTestId('reset').click()
    await new RacePage(page).ready()
  }
  // Every planner is known, so that lists are complete.
  await expect(page.locator('option[value="max-min-ant-system"]').first()).toBeAttached()
  return page
}

/** Every control on show: what it is called, and whether it can be used. */
const controls = (page: Page) =>
  page.evaluate(() =>
    [
      ...document.querySelectorAll<HTMLElement>(
        'button, input, select, textarea, summary, [role="menuitemradio"], [tabindex="0"]',
      ),
    ]
      .filter((one) => one.checkVisibility())
      .map((one) => {
        const { value, disabled } = one as HTMLInputElement
        const name = one.dataset.testid ?? one.getAttribute('aria-label') ?? one.textContent
        const { height, width } = one.getBoundingClientRect()
        return [name, one.tagName, value, disabled, Math.round(width), Math.round(height)].join(' ')
      })
      .sort(),
  )

for (const view of ['race', 'lab'] as const) {
  test(`${view} has the same controls, whichever view was opened first`, async ({ browser }) => {
    const direct = await opened(browser, view, view)
    const round = await opened(browser, view === 'race' ? 'lab' : 'race', view)
    await expect(async () => {
      const expected = await controls(direct)
      expect(expected.length).toBeGreaterThan(20)
      expect(await controls(round)).toEqual(expected)
    }).toPass({ timeout: 20_000 })
    for (const page of [direct, round]) await page.context().close()
  })
}

for (const first of ['race', 'lab'] as const) {
  test(`Watch does what it says where ${first} was opened first`, async ({ browser }) => {
    test.slow()
    const page = await opened(browser, first, 'race')
    const race = new RacePage(page)
    const use = (testId: string) => page.getByTestId(testId).click()
    const phase = (name: string) =>
      expect(page.getByTestId('play')).toHaveAttribute('data-phase', name)
    await use('play')
    await phase('running')
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await use('play')
    await phase('paused')
    const moves = await race.antMoves()
    await use('step-iteration')
    await expect.poll(() => race.antMoves()).toBeGreaterThan(moves)
    await expect(page.getByTestId('look-earlier')).toBeEnabled()
    await use('look-earlier')
    await expect(page.getByTestId('look-later')).toBeEnabled()
    await use('step-move')
    await use('run-to-end')
    await phase('finished')
    await use('reset')
    await phase('editing')
    expect(await race.antMoves()).toBe(0)

    const before = await race.session()
    await use('new-seed')
    await expect.poll(async () => (await race.session()).seed).not.toBe(before.seed)
    await page.getByTestId('sync').selectOption('iterations')
    await page.getByTestId('layer').selectOption('none')
    await race.setSpeed(5)
    expect(await race.session()).toMatchObject({ sync: 'iterations', layer: 'none', speed: 5 })
    const walls = await race.walls()
    await race.drag([[20, 12]])
    await expect.poll(() => race.walls()).not.toBe(walls)
    await use('undo')
    await expect.poll(() => race.walls()).toBe(walls)
    await use('redo')
    await expect.poll(() => race.walls()).not.toBe(walls)
    await race.menu('add-panel', 'add-max-min-ant-system')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await use('remove-3')
    await expect(page.getByTestId('panel-3')).toHaveCount(0)
    await page.getByTestId('param-ants').fill('7')
    await page.getByTestId('param-ants').press('Enter')
    expect((await race.session()).panels[0]?.params).toEqual({ ants: 7 })
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    expect(await race.shareLink()).toContain('#x=')
    await race.ready()
    await use('play')
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await page.context().close()
  })

  test(`Compare does what it says where ${first} was opened first`, async ({ browser }) => {
    const page = await opened(browser, first, 'lab')
    const comparison = new ComparisonPage(page)
    await comparison.add('rank-based-ant-system')
    await comparison.compare('ant-system', 'astar')
    await comparison.on('two-corridors', 'open-field')
    await comparison.seeds(2, 5)
    await comparison.set(1, 'iterations', 4)
    await page.getByTestId('budget-axis').selectOption('iterations')
    await comparison.type('budget-amount', 3)
    await comparison.run()
    await comparison.finished()
    const rows = await page.evaluate(() => window.formicarium.resultFile('csv'))
    // Two maps, two planners, two seeds, below a line of names.
    expect(rows.trim().split('\n')).toHaveLength(1 + 8)
    await page.getByTestId('lab-back').click()
    await page.getByTestId('take-race').click()
    await expect(comparison.maps).toHaveCount(1)
    await expect(comparison.entries).toHaveCount(2)
    await expect(comparison.start).toBeEnabled()
    await page.context().close()
  })
}
