/** A robot that drives where walls change and obstacles move: drawn, driven, undone, sent, and the same as on the command line. */
import { expect, type Page, test } from '@playwright/test'
import type { Session } from '../../www/src/model/session'
import { packBits } from '../../www/src/share/codec'
import { seal } from '../../www/src/share/envelope'
import { expectClean } from './axe'
import { answered, commandLine } from './command_line'
import { RacePage } from './race_page'
import { sessionOf } from './units/sessions'

/** A colony and a search on 14 × 8 cells, open but for one wall. */
function field(): Session {
  const cells = new Uint8Array(112)
  for (const y of [3, 4]) cells[14 * y + 3] = 1
  const session = sessionOf(14, 8, cells)
  const { spec } = session.scenario
  const goal = { at: [13, 4] as [number, number], name: '', area: 1, strength: 1, danger: 1 }
  const movement = { moves: 8 as const, corner_rule: 'one-free' as const }
  const asked = { ...spec, start: [0, 4] as [number, number], goals: [goal], movement }
  const search = { planner: 'astar', preset: null, params: {}, label: null, result: null }
  const colony = { ...search, planner: 'ant-system', params: { ants: 8 } }
  return {
    ...session,
    scenario: { ...session.scenario, spec: asked },
    panels: [search, colony],
    seed: 7,
  }
}

async function open(page: Page, session = field()): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest(`./#x=${await seal(packBits(session, '0.1.0'))}`)
  await expect(page.getByTestId('lesson-menu')).toBeVisible()
  return race
}

async function openDrive(page: Page): Promise<void> {
  await page.getByTestId('lesson-menu').click()
  await page.getByTestId('lesson-drive').click()
  await expect(page.getByTestId('drive-play')).toBeEnabled()
}

const driveOf = async (race: RacePage) => (await race.session()).scenario.spec.drive
const value = async (page: Page, what: string) =>
  Number(await page.getByTestId(`drive-${what}`).getAttribute('data-value'))

/** Drives to the end, and waits for the best in advance. */
async function driveThrough(page: Page): Promise<void> {
  await page.getByTestId('drive-pace').selectOption('100')
  await page.getByTestId('drive-play').click()
  await expect(page.getByTestId('drive-best')).toHaveAttribute('data-value', /\d/)
}

test.describe('a drive', () => {
  test('through an obstacle that was drawn comes to what the command line says', async ({
    page,
  }) => {
    const cli = commandLine()
    const session = field()
    // Ground that costs more lies on the straight way.
    const factors = new Float32Array(112).fill(1)
    factors.fill(3, 14 * 4 + 5, 14 * 4 + 8)
    session.scenario.factors = factors
    const race = await open(page, session)
    await openDrive(page)
    await page.getByTestId('add-obstacle').click()
    await race.drag([
      [8, 1],
      [8, 6],
    ])
    await expect.poll(async () => (await driveOf(race))?.tracks?.[0]?.cells.length).toBe(6)
    await page.getByTestId('track-steps_per_cell').fill('2')
    await page.getByTestId('track-steps_per_cell').press('Tab')
    await expect.poll(async () => (await driveOf(race))?.tracks?.[0]?.steps_per_cell).toBe(2)
    await page.getByTestId('drive-done').click()
    await expect(page.getByTestId('drive-play')).toBeEnabled()
    await driveThrough(page)
    await expect(page.getByTestId('drive-standing')).toContainText('Arrived')

    for (const [planner, set] of [
      ['astar', []],
      ['ant-system', ['--set', 'ants=8']],
    ] as const) {
      if (planner === 'ant-system') {
        await page.getByTestId('drive-planner').selectOption({ index: 1 })
        await expect(page.getByTestId('drive-standing')).toContainText('At the start')
        await driveThrough(page)
      }
      const map = (await race.exported('scenario')).bytes
      const args = ['drive', 'map.json', '--planner', planner, '--seed', '7', ...set]
      const told = answered<Told>(cli, { 'map.json': map }, args)
      expect(await value(page, 'length')).toBe(told.length)
      expect(await value(page, 'best')).toBe(told.clairvoyant.value)
      expect(await value(page, 'ratio')).toBe(told.ratio)
      expect(await value(page, 'replans')).toBe(told.replans)
      expect(await value(page, 'waits')).toBe(told.waits)
      const effort = planner === 'astar' ? 'expansions' : 'antMoves'
      const spent = planner === 'astar' ? told.effort.cell_expansions : told.effort.ant_moves
      expect(await value(page, effort)).toBe(spent)
    }
  })

  test('of a robot with a radius keeps clear of the wall, and of what moves', async ({ page }) => {
    const session = field()
    // One cell: beside the wall there is no room.
    session.scenario.spec = { ...session.scenario.spec, robot: { radius: 0.5 } }
    const race = await open(page, session)
    await openDrive(page)
    const cell = (await race.pointOf([1, 0])).x - (await race.pointOf([0, 0])).x
    const extent = page.locator('.drive-marks .extent')
    expect(Number(await extent.getAttribute('r'))).toBeCloseTo(cell, 0)
    await driveThrough(page)
    const alone = await value(page, 'length')
    expect(alone).toBeGreaterThan(13)
    await page.getByTestId('add-obstacle').click()
    await race.drag([
      [8, 1],
      [8, 6],
    ])
    await page.getByTestId('drive-done').click()
    await expect(page.getByTestId('drive-standing')).toContainText('At the start')
    await driveThrough(page)
    await expect(page.getByTestId('drive-standing')).toContainText('Arrived')
    expect(await value(page, 'length')).toBeGreaterThanOrEqual(alone)
    expect(await value(page, 'ratio')).toBeGreaterThanOrEqual(1)
    expect(await value(page, 'replans')).toBeGreaterThan(0)
  })

  test('leaves the race alone, and its edits are undone one by one', async ({ page }) => {
    const race = await open(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    const before = await race.results()
    await openDrive(page)
    await page.getByTestId('drive-example').click()
    await expect.poll(async () => (await driveOf(race))?.tracks?.length).toBe(1)
    await page.getByTestId('add-walls').click()
    await race.drag([
      [5, 1],
      [5, 3],
    ])
    await expect
      .poll(async () => (await driveOf(race))?.changes)
      .toEqual([
        {
          at_step: 10,
          blocked: [
            [5, 1],
            [5, 2],
            [5, 3],
          ],
          freed: [],
        },
      ])
    // A press on a cell that changes takes it out again.
    await race.drag([[5, 2]])
    await expect.poll(async () => (await driveOf(race))?.changes?.[0]?.blocked?.length).toBe(2)
    expect((await race.results()).map(({ summary }) => summary?.digest)).toEqual(
      before.map(({ summary }) => summary?.digest),
    )
    await page.getByTestId('undo').click()
    await expect.poll(async () => (await driveOf(race))?.changes?.[0]?.blocked?.length).toBe(3)
    await page.getByTestId('undo').click()
    await expect.poll(async () => (await driveOf(race))?.changes?.length).toBe(0)
    await page.getByTestId('undo').click()
    await expect.poll(() => driveOf(race)).toBeUndefined()
    await page.getByTestId('redo').click()
    await expect.poll(async () => (await driveOf(race))?.tracks?.length).toBe(1)
    await page.getByTestId('drive-card-close').click()
    await expect(page.getByTestId('drive-marks')).toHaveCount(0)
    expect((await race.results()).map(({ summary }) => summary?.digest)).toEqual(
      before.map(({ summary }) => summary?.digest),
    )
  })

  test('leaves the goal free, and says so', async ({ page }) => {
    const race = await open(page)
    await openDrive(page)
    await page.getByTestId('add-walls').click()
    await race.drag([[13, 4]])
    await expect(page.locator('.toasts')).toContainText('not upon it')
    expect(await driveOf(race)).toBeUndefined()
    await race.drag([
      [13, 2],
      [13, 5],
    ])
    const cells = async () => (await driveOf(race))?.changes?.[0]?.blocked
    await expect.poll(cells).toEqual([
      [13, 2],
      [13, 3],
      [13, 5],
    ])
  })

  test('is drawn and driven with keys alone', async ({ page }) => {
    const race = await open(page)
    await openDrive(page)
    await page.getByTestId('add-obstacle').focus()
    await page.keyboard.press('Enter')
    await race.stage().focus()
    for (const key of ['ArrowRight', 'Enter', 'ArrowRight', 'ArrowRight', 'Enter'])
      await page.keyboard.press(key)
    await expect.poll(async () => (await driveOf(race))?.tracks?.[0]?.cells.length).toBe(3)
    // Esc leaves the drawing first, and then the drive.
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('drive-card')).toBeVisible()
    await expect(page.getByTestId('drive-step')).toBeEnabled()
    await page.getByTestId('drive-step').focus()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('drive-standing')).toContainText('Step 1')
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('drive-card')).toHaveCount(0)
  })

  test('what the engine does not take is refused with its reason, and nothing changes', async ({
    page,
  }) => {
    const race = await open(page)
    await openDrive(page)
    await page.getByTestId('drive-example').click()
    await page.getByTestId('obstacle-1').click()
    await page.getByTestId('track-size').fill('65')
    await page.getByTestId('track-size').press('Tab')
    await expect(page.getByTestId('drive-moving').getByRole('alert')).toContainText('64')
    expect((await driveOf(race))?.tracks?.[0]?.size).toBe(1)
    await page.getByTestId('track-at_end').selectOption('leave')
    await expect.poll(async () => (await driveOf(race))?.tracks?.[0]?.at_end).toBe('leave')
    await expect(page.getByTestId('drive-moving').getByRole('alert')).toHaveCount(0)
  })

  test('tells where the robot believes wrongly, and why it gave up', async ({ page }) => {
    const session = field()
    // The whole column before the goal is walled up behind its back, out of sight.
    const wall = Array.from({ length: 8 }, (_, y): [number, number] => [11, y])
    session.scenario.spec = {
      ...session.scenario.spec,
      drive: { changes: [{ at_step: 1, blocked: wall, freed: [] }], tracks: [], sight: 2 },
    }
    await open(page, session)
    await openDrive(page)
    await page.getByTestId('drive-settings').locator('summary').click()
    await page.getByTestId('param-patience').last().fill('2')
    await page.getByTestId('param-patience').last().press('Tab')
    await expect(page.getByTestId('drive-play')).toBeEnabled()
    await page.getByTestId('drive-step').click()
    await expect(page.locator('.drive-marks .believed-free')).toHaveCount(8)
    await page.getByTestId('drive-pace').selectOption('100')
    await page.getByTestId('drive-play').click()
    await expect(page.getByTestId('drive-standing')).toContainText('no path leads to the goal')
    await expectClean(page, 'a drive that has ended')
  })
})

test('what nobody can drive is told, and why', async ({ page }) => {
  const session = field()
  const [goal] = session.scenario.spec.goals
  if (!goal) throw new Error('there is a goal')
  const second = { ...goal, at: [7, 7] as [number, number], name: 'second' }
  session.scenario.spec = { ...session.scenario.spec, goals: [goal, second] }
  const [, colony] = session.panels
  await open(page, { ...session, panels: colony ? [{ ...colony, planner: 'fire' }] : [] })
  await page.getByTestId('lesson-menu').click()
  await page.getByTestId('lesson-drive').click()
  await expect(page.getByTestId('drive-card').getByRole('alert')).toHaveText(
    'A robot drives to one goal; this map has 2.',
  )
  await expect(page.getByTestId('drive-play')).toBeDisabled()
  // There is nothing to be drawn for a drive that cannot be.
  await expect(page.getByTestId('add-obstacle')).toHaveCount(0)
  await expectClean(page, 'a map on which nobody drives')
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('drive-card')).toHaveCount(0)
})

test('is legible in dark and in Chinese, with everything open', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.addInitScript(() => localStorage.setItem('formicarium.language', 'zh-CN'))
  await new RacePage(page).open(`./#x=${await seal(packBits(field(), '0.1.0'))}`)
  await openDrive(page)
  await page.getByTestId('drive-example').click()
  await page.getByTestId('obstacle-1').click()
  await page.getByTestId('drive-settings').locator('summary').click()
  await page.getByTestId('sight-some').click()
  await expect(page.getByTestId('sight-cells')).toBeVisible()
  await expect(page.getByTestId('drive-card')).toContainText('耐心')
  await expect(page.getByTestId('drive-card')).not.toContainText(/drive\.|patience/)
  await expectClean(page, 'a drive in dark and Chinese')
})

test('a link with a drive offers it, and brings it back as it was', async ({ page, browser }) => {
  const race = await open(page)
  await openDrive(page)
  await page.getByTestId('drive-example').click()
  await expect.poll(async () => (await driveOf(race))?.tracks?.length).toBe(1)
  const drive = await driveOf(race)
  const other = new RacePage(await (await browser.newContext()).newPage())
  await other.open(await race.shareLink())
  expect(await driveOf(other)).toEqual(drive)
  await other.page.locator('.toasts').getByRole('button', { name: 'Drive' }).click()
  await expect(other.page.getByTestId('drive-card')).toBeVisible()
  await expect(other.page.getByTestId('obstacle-1')).toBeVisible()
})

test('what no longer fits a map is left out, with a word, and comes back with undo', async ({
  page,
}) => {
  const session = field()
  session.scenario.spec = {
    ...session.scenario.spec,
    drive: {
      changes: [
        {
          at_step: 2,
          blocked: [
            [6, 1],
            [6, 2],
          ],
          freed: [],
        },
      ],
      tracks: [
        {
          cells: [
            [8, 6],
            [8, 7],
          ],
          size: 1,
          from_step: 0,
          steps_per_cell: 1,
          at_end: 'loop',
        },
      ],
    },
  }
  const race = await open(page, session)
  await expect(page.locator('.toasts')).toContainText('Things move')
  const before = await driveOf(race)
  await page.getByTestId('tool-wall').click()
  await race.drag([[6, 1]])
  await expect.poll(async () => (await driveOf(race))?.changes?.[0]?.blocked).toEqual([[6, 2]])
  await expect(page.locator('.toasts')).toContainText('no longer fits')
  expect((await driveOf(race))?.tracks).toEqual(before?.tracks)
  await page.getByTestId('undo').click()
  await expect.poll(() => driveOf(race)).toEqual(before)
})

test('several goals are the reason named in Chinese, and no obstacle is offered', async ({
  page,
}) => {
  const session = field()
  const [goal] = session.scenario.spec.goals
  if (!goal) throw new Error('the map has no goal')
  session.scenario.spec.goals = [goal, { ...goal, at: [1, 1], name: 'on the way' }]
  session.panels = session.panels.map((panel) => ({ ...panel, planner: 'fire', params: {} }))
  const race = await open(page, session)
  // At once: the words of the drive come while the language is on its way.
  await race.menu('language', 'language-zh-CN')
  await page.getByTestId('lesson-menu').click()
  await page.getByTestId('lesson-drive').click()
  const alert = page.getByTestId('drive-card').getByRole('alert')
  await expect(alert).toContainText('机器人只驶向一个目标；这张地图有 2 个')
  await expect(page.getByTestId('drive-example')).toHaveCount(0)
})

test('an obstacle tells its size apart from its track', async ({ page }) => {
  const session = field()
  const cells: [number, number][] = [
    [8, 1],
    [8, 2],
    [8, 3],
  ]
  session.scenario.spec.drive = { changes: [], tracks: [{ cells, size: 2 }] }
  await open(page, session)
  await page.getByTestId('lesson-menu').click()
  await page.getByTestId('lesson-drive').click()
  await expect(page.getByTestId('obstacle-1')).toContainText('Obstacle 1, 2 × 2: track of 3 cells')
})

test('on a phone a card opens in front of the sheet, which makes room for it @phone', async ({
  page,
}) => {
  await open(page)
  await page.getByTestId('column').tap()
  await expect(page.getByTestId('close-column')).toBeVisible()
  await page.getByTestId('lesson-menu').tap()
  await page.getByTestId('lesson-drive').tap()
  await expect(page.getByTestId('drive-card')).toBeInViewport()
  await expect(page.getByTestId('close-column')).toBeHidden()
})

test('on a phone the card stands below the map, and nothing is too small @phone', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest(`./#x=${await seal(packBits(field(), '0.1.0'))}`)
  await page.getByTestId('lesson-menu').tap()
  await page.getByTestId('lesson-drive').tap()
  await expect(page.getByTestId('drive-example')).toBeVisible()
  await page.getByTestId('drive-example').tap()
  await page.getByTestId('drive-play').tap()
  await expect.poll(() => value(page, 'length')).toBeGreaterThan(0)
  await expect(race.stage()).toBeInViewport()
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
  expect(overflow).toBeLessThanOrEqual(0)
  await expectClean(page, 'a drive on a phone')
})

interface Told {
  length: number
  clairvoyant: { value: number }
  ratio: number
  replans: number
  waits: number
  effort: { cell_expansions: number; ant_moves: number }
}
