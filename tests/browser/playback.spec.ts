import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { countCalls, drawn, ticks } from './workers'

const phase = (page: Page, is: 'running' | 'paused') =>
  expect(page.getByTestId('play')).toHaveAttribute('data-phase', is)

/** A colony that has not ended by the time a test has, however fast the machine is. */
async function manyIterations(race: RacePage): Promise<void> {
  await race.page.getByTestId('parameters-1').click()
  const field = await race.param('iterations')
  await field.fill('100000')
  await field.press('Enter')
  await race.ready()
}

/** Waits until the first panel's run has ended, and tells how. */
async function ended(race: RacePage, timeout: number): Promise<string | undefined> {
  const summary = async () => (await race.result(1)).summary
  const status = async () => (await summary())?.status ?? 'loading'
  await expect.poll(status, { timeout }).not.toMatch(/loading|running/)
  return (await summary())?.digest
}

test.describe('playback', () => {
  test.beforeEach(async ({ page }) => {
    await countCalls(page)
    await new RacePage(page).openAtRest()
  })

  test('play and pause, by button and by Space', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await page.keyboard.press('Escape')
    await page.locator('body').press('Space')
    await phase(page, 'paused')
    const held = await ticks(page)
    await page.waitForTimeout(400)
    expect(await ticks(page)).toBe(held)
    const moves = await race.antMoves()
    await page.locator('body').press('Space')
    await phase(page, 'running')
    await expect.poll(() => ticks(page)).toBeGreaterThan(held)
    await expect.poll(() => race.antMoves()).toBeGreaterThan(moves)
  })

  test('a move is one step of every living ant and one cell of a search', async ({ page }) => {
    const race = new RacePage(page)
    const expanded = async () => (await race.result(2)).summary?.effort.cell_expansions
    await drawn(page)
    await race.seesMotion(1, () => page.getByTestId('step-move').click())
    await expect.poll(expanded).toBe(1)
    await drawn(page)
    await race.seesMotion(1, () => page.locator('body').press('ArrowRight'))
    await expect.poll(expanded).toBe(2)
  })

  test('an iteration, by button and by key', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('step-iteration').click()
    await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(1)
    await page.locator('body').press(']')
    await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(2)
    await page.locator('body').press('Shift+ArrowRight')
    await expect.poll(async () => (await race.result(1)).summary?.iteration).toBe(3)
    expect((await race.result(1)).history).toHaveLength(3)
  })

  test('steps pressed in a row are all taken', async ({ page }) => {
    const race = new RacePage(page)
    for (let i = 0; i < 10; i++) await page.locator('body').press('ArrowRight')
    await expect.poll(async () => (await race.result(2)).summary?.effort.cell_expansions).toBe(10)
  })

  test('reset begins again, and the same seed walks the same way', async ({ page }) => {
    const race = new RacePage(page)
    const digests: (string | undefined)[] = []
    for (let run = 0; run < 2; run++) {
      await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
      digests.push((await race.result(1)).summary?.digest)
      await page.getByTestId('reset').click()
      await expect.poll(() => race.antMoves()).toBe(0)
    }
    expect(digests[0]).toMatch(/^[0-9a-f]{16}$/)
    expect(digests[1]).toBe(digests[0])
    await page.getByTestId('seed').fill('99')
    await page.getByTestId('seed').press('Enter')
    await race.ready()
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    expect((await race.result(1)).summary?.digest).not.toBe(digests[0])
  })

  test('move by move and iteration by iteration end alike', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('run-to-end').click()
    const atOnce = await ended(race, 20_000)
    await page.getByTestId('reset').click()
    await expect.poll(() => race.antMoves()).toBe(0)
    await race.setSpeed(5)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await race.setSpeed(7)
    expect(await ended(race, 30_000)).toBe(atOnce)
    expect(atOnce).toMatch(/^[0-9a-f]{16}$/)
  })

  for (const sync of ['iterations', 'paths', 'time']) {
    test(`in step by ${sync}`, async ({ page }) => {
      const race = new RacePage(page)
      await page.getByTestId('sync').selectOption(sync)
      await race.menu('add-panel', 'add-ant-system')
      await race.ready()
      await race.setSpeed(5)
      await page.getByTestId('play').click()
      await expect
        .poll(async () => (await race.result(1)).summary?.iteration ?? 0, { timeout: 20_000 })
        .toBeGreaterThan(2)
      if (sync === 'time') return
      // Panels that count the same are never further apart than this, not even while they run.
      const [first, , third] = await race.results()
      expect(
        Math.abs((first?.summary?.iteration ?? 0) - (third?.summary?.iteration ?? 99)),
      ).toBeLessThanOrEqual(1)
    })
  }

  test('speed may change while it plays', async ({ page }) => {
    const race = new RacePage(page)
    await manyIterations(race)
    await page.getByTestId('play').click()
    await race.setSpeed(0)
    await race.seesMotion()
    for (const speed of [5, 4, 6]) {
      await race.setSpeed(speed)
      const before = await race.antMoves()
      await expect.poll(async () => (await race.antMoves()) > before).toBe(true)
    }
  })

  test('layers, ants and path can be switched while it runs', async ({ page }) => {
    const race = new RacePage(page)
    await manyIterations(race)
    await page.getByTestId('play').click()
    for (const layer of await page
      .getByTestId('layer')
      .locator('option')
      .evaluateAll((all) => all.map((one) => (one as HTMLOptionElement).value))) {
      await page.getByTestId('layer').selectOption(layer)
      await race.frame()
    }
    await page.getByTestId('show-ants').click()
    await page.getByTestId('show-path').click()
    const before = await race.antMoves()
    await expect.poll(async () => (await race.antMoves()) > before).toBe(true)
  })
})
