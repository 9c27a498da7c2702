/** Walls that change while planners run: trails are kept, and a link repeats it. */
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { freshRace, RacePage } from './race_page'
import { drawn } from './workers'

const iteration = async (race: RacePage, place = 1) =>
  (await race.result(place)).summary?.iteration ?? 0

/** A race that has run a little, with the choice to keep the trails. */
async function keeping(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('keep-trails').selectOption('keep')
  await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
  return race
}

/** Blocks the cell in the middle of the best path of the first panel. */
async function blockPath(race: RacePage): Promise<[number, number]> {
  const { path } = await race.result(1)
  const cell = path?.[path.length >> 1]
  if (!cell) throw new Error('there is no path')
  await race.drag([cell])
  return cell
}

const changes = async (race: RacePage) => (await race.session()).changes ?? []

test.describe('walls that change during a run', () => {
  test('with the trails kept, iterations go on and no path crosses the wall', async ({ page }) => {
    const race = await keeping(page)
    const cell = await blockPath(race)
    await expect.poll(async () => (await changes(race)).length).toBe(1)
    expect((await changes(race))[0]).toMatchObject({ blocked: [cell], freed: [] })
    await expect.poll(async () => (await race.result(1)).summary?.changes).toBe(1)
    expect(await iteration(race)).toBe(6)
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    const after = await race.result(1)
    expect(after.summary?.iteration).toBe(8)
    expect(after.path).not.toContainEqual(cell)
    expect(after.history.map(([number]) => number)).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
    await expect(page.getByTestId('toast-info').filter({ hasText: 'trails stay' })).toContainText(
      'A*',
    )
  })

  test('a link repeats the run with its changes, bit for bit', async ({ page, browser }) => {
    const race = await keeping(page)
    const cell = await blockPath(race)
    await expect.poll(async () => (await race.result(1)).summary?.changes).toBe(1)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await page.keyboard.press('Control+z')
    await expect.poll(async () => (await race.result(1)).summary?.changes).toBe(2)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    const before = await race.results()
    const other = await freshRace(browser, await race.shareLink())
    const verified = other.page.getByTestId('verified-1')
    await expect(verified).toHaveAttribute('data-verified', 'verified')
    await expect(other.page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
    const opened = await changes(other)
    expect(opened.map(({ blocked, freed }) => [blocked, freed])).toEqual([
      [[cell], []],
      [[], [cell]],
    ])
    expect(before[0]?.summary?.digest).toBeDefined()
    await other.page.context().close()
  })

  test('a stroke while everything plays is one change, made by colonies and swarms alike', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('keep-trails').selectOption('keep')
    for (const planner of ['max-min-ant-system', 'pso'])
      await race.menu('add-panel', `add-${planner}`)
    await race.ready()
    await page.getByTestId('play').click()
    await expect.poll(() => iteration(race)).toBeGreaterThan(2)
    const before = await iteration(race)
    await race.drag([
      [1, 1],
      [6, 1],
    ])
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'running')
    const made = async () => (await race.results()).map(({ summary }) => summary?.changes ?? 0)
    await expect.poll(made).toEqual([1, 1, 1, 1])
    await expect.poll(() => iteration(race)).toBeGreaterThan(before)
    await page.getByTestId('play').click()
    const [change, ...more] = await changes(race)
    expect(more).toEqual([])
    expect(change?.at.length).toBe(4)
    expect((change?.blocked.length ?? 0) + (change?.freed.length ?? 0)).toBeGreaterThan(2)

    const other = await freshRace(browser, await race.shareLink())
    for (const place of [1, 2, 3, 4])
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    await other.page.context().close()
  })

  test('without the choice runs start anew, as ever', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await race.drag([[2, 2]])
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
    expect(await changes(race)).toEqual([])
  })

  test('a reset begins on the map as it is', async ({ page }) => {
    const race = await keeping(page)
    const cell = await blockPath(race)
    await expect.poll(async () => (await changes(race)).length).toBe(1)
    await page.getByTestId('begin-on-this-map').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
    expect(await changes(race)).toEqual([])
    expect(await race.isWall(cell)).toBe(true)
  })

  test('the choice is kept on the device, and clean for assistive technology', async ({ page }) => {
    const race = await keeping(page)
    await blockPath(race)
    await expect(page.getByTestId('begin-on-this-map')).toBeVisible()
    await expectClean(page, 'walls that changed')
    await page.reload()
    await expect(page.getByTestId('keep-trails')).toHaveValue('keep')
  })

  test('a wall may come and go within one iteration, and a link repeats it', async ({
    page,
    browser,
  }) => {
    const race = await keeping(page)
    await page.getByTestId('step-move').click()
    await race.drag([[1, 1]])
    await page.keyboard.press('Control+z')
    await page.keyboard.press('Control+Shift+z')
    await expect.poll(async () => (await changes(race)).length).toBe(3)
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    const results = await race.results()
    expect(results.map(({ summary, error }) => [summary?.changes, error])).toEqual([
      [3, null],
      [3, null],
    ])
    const other = await freshRace(browser, await race.shareLink())
    for (const place of [1, 2])
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    await other.page.context().close()
  })

  test('strokes while the whole engine is still being fetched are in every run', async ({
    page,
    browser,
  }) => {
    let release = () => {}
    const held = new Promise<void>((resolve) => {
      release = resolve
    })
    const race = new RacePage(page)
    await race.openAtRest()
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await page.route(/formicarium_bg-.*\.wasm/, async (route) => {
      await held
      await route.continue()
    })
    await page.getByTestId('keep-trails').selectOption('keep')
    await race.drag([[1, 3]])
    await race.drag([[10, 18]])
    release()
    const made = async () => (await race.results()).map(({ summary }) => summary?.changes ?? 0)
    await expect.poll(made).toEqual([2, 2])
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    const other = await freshRace(browser, await race.shareLink())
    for (const place of [1, 2])
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    await other.page.context().close()
  })

  test('looking back to a map before a change compares with nothing', async ({ page }) => {
    const race = await keeping(page)
    await expect(page.getByTestId('gap-1')).toContainText('%')
    await blockPath(race)
    await expect.poll(async () => (await race.result(1)).summary?.changes).toBe(1)
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await page.evaluate(() => window.formicarium.look(3))
    await expect(page.getByTestId('gap-1')).not.toContainText('%')
    await page.evaluate(() => window.formicarium.look(null))
    await expect(page.getByTestId('gap-1')).toContainText('%')
  })

  test('while one draws, walls that have changed before are still there', async ({ page }) => {
    const race = await keeping(page)
    const cell = await blockPath(race)
    await expect.poll(async () => (await race.result(1)).summary?.changes).toBe(1)
    await page.getByTestId('keep-trails').selectOption('anew')
    const [from, seen] = [await race.pointOf([1, 1]), await race.pointOf(cell)]
    const clip = { x: seen.x - 2, y: seen.y - 2, width: 4, height: 4 }
    // The cell under the pointer is lighter.
    await page.mouse.move(from.x, from.y)
    await drawn(page)
    const wall = await page.screenshot({ clip })
    await page.mouse.down()
    for (let i = 0; i < 4; i++) await race.frame()
    await drawn(page)
    expect(wall.equals(await page.screenshot({ clip }))).toBe(true)
    await page.mouse.up()
  })
})
