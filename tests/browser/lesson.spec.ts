/** Lessons: stops, one ant, guesses, a path by hand and a target, each by pointer and by keyboard. */
import { expect, type Page, test } from '@playwright/test'
import type { Lesson } from '../../www/src/model/lesson'
import type { Session } from '../../www/src/model/session'
import { packBits } from '../../www/src/share/codec'
import { seal } from '../../www/src/share/envelope'
import { expectClean } from './axe'
import { RacePage } from './race_page'
import { sessionOf } from './units/sessions'

/** A colony and a search on 8 × 6 cells with one wall, from the upper left to the lower right. */
function small(lesson?: Lesson): Session {
  const cells = new Uint8Array(48)
  for (const y of [1, 2, 3]) cells[8 * y + 4] = 1
  const { result: _, ...ants } = sessionOf(8, 6, cells).panels[0] ?? {}
  const colony = {
    ...ants,
    planner: 'ant-system',
    preset: null,
    params: { ants: 6 },
    label: null,
    result: null,
  }
  const search = { planner: 'astar', preset: null, params: {}, label: null, result: null }
  const session = { ...sessionOf(8, 6, cells), panels: [colony, search], seed: 5, speed: 8 }
  return lesson ? { ...session, lesson } : session
}

async function open(page: Page, lesson?: Lesson): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest(`./#x=${await seal(packBits(small(lesson), '0.1.0'))}`)
  await expect(page.getByTestId('lesson-menu')).toBeVisible()
  return race
}

const lessonOf = async (race: RacePage) => (await race.session()).lesson
const stands = (race: RacePage) =>
  Promise.all(
    [1, 2].map(async (place) => {
      const { summary } = await race.result(place)
      return [summary?.iteration, summary?.digest, summary?.moves]
    }),
  )

test.describe('stops', () => {
  test('a race stops at the iteration where it happens, at any speed, and says who met what', async ({
    page,
  }) => {
    const race = await open(page)
    await page.getByTestId('stops').click()
    await page.getByTestId('stop-iteration').check()
    await page.getByTestId('stop-iteration-count').fill('7')
    await page.getByTestId('stop-iteration-count').press('Tab')
    await expectClean(page, 'the box of stops')
    await page.keyboard.press('Escape')
    expect((await lessonOf(race))?.stops).toEqual([{ when: 'iteration', iterations: 7 }])

    const found: unknown[] = []
    for (const speed of [8, 7, 6]) {
      await race.setSpeed(speed)
      await page.getByTestId('play').click()
      await expect(page.getByTestId('play')).toHaveAttribute('data-phase', /paused|finished/)
      await expect(page.locator('.stop-chip').first()).toContainText('iteration 7')
      await expect(page.locator('.toasts')).toContainText('Ant System · m 6: iteration 7')
      found.push(await stands(race))
      await page.getByTestId('reset').click()
      await race.ready()
    }
    expect((found[0] as unknown[][])[0]?.[0]).toBe(7)
    expect(found[1]).toEqual(found[0])
    expect(found[2]).toEqual(found[0])
  })

  test('what was met does not hold again, and a first path is met where the engine has it', async ({
    page,
  }) => {
    const race = await open(page, { stops: [{ when: 'first-path' }, { when: 'panel-ends' }] })
    await page.getByTestId('play').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', /paused/)
    const first = await race.results()
    const met = first.filter(({ summary }) => summary?.metrics)
    expect(met.length).toBeGreaterThan(0)
    for (const { summary } of met)
      if (summary?.iteration_of_best) expect(summary.iteration).toBe(summary.iteration_of_best)
    let phase = 'paused'
    for (let presses = 0; presses < 6 && phase === 'paused'; presses++) {
      await page.getByTestId('play').click()
      await expect(page.getByTestId('play')).toHaveAttribute('data-phase', /paused|finished/)
      phase = (await page.getByTestId('play').getAttribute('data-phase')) ?? ''
    }
    expect(phase).toBe('finished')
  })

  test('a search has contours and no iterations: only colonies meet such stops', async ({
    page,
  }) => {
    const race = await open(page, { stops: [{ when: 'iteration', iterations: 3 }] })
    await page.getByTestId('play').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', /paused/)
    const [colony, search] = await race.results()
    expect(colony?.stops).toEqual([{ when: 'iteration', iterations: 3 }])
    expect(search?.stops).toEqual([])
  })

  test('by keyboard: End asks whether stops count', async ({ page }) => {
    const race = await open(page, { stops: [{ when: 'iteration', iterations: 3 }] })
    await page.locator('body').press('End')
    await expect(page.getByTestId('run-to-stop')).toBeFocused()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'paused')
    expect((await race.result(1)).summary?.iteration).toBe(3)
    await page.locator('body').press('End')
    await page.getByTestId('run-through').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'finished')
    // With the keyboard alone a stop is chosen and left.
    await page.getByTestId('stops').focus()
    await page.keyboard.press('Enter')
    await page.getByTestId('stop-panel-ends').focus()
    await page.keyboard.press(' ')
    await page.keyboard.press('Escape')
    expect((await lessonOf(race))?.stops?.map(({ when }) => when)).toEqual([
      'iteration',
      'panel-ends',
    ])
  })
})

const where = (page: Page) => page.getByTestId('ant-where')

test.describe('one ant', () => {
  test('is followed: a look ahead leaves the run alone, and the ant then does exactly that', async ({
    page,
  }) => {
    const race = await open(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    await page.getByTestId('step-move').click()
    await page.getByTestId('step-move').click()
    await race.menu('lesson-menu', 'lesson-follow')
    await page.getByTestId('ant-number').fill('3')
    await page.getByTestId('ant-number').press('Enter')
    await expect(where(page)).toHaveAttribute('data-moves', '2')
    await expect(page.getByTestId('ant-agrees')).toHaveAttribute('data-agrees', 'true')
    const shares = await page
      .getByTestId('move')
      .evaluateAll((rows) => rows.map((row) => Number((row as HTMLElement).dataset.probability)))
    expect(shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 9)
    await expectClean(page, 'the card of an ant')

    const before = await stands(race)
    await page.getByTestId('ant-step').click()
    await expect(where(page)).toHaveAttribute('data-moves', '3')
    await expect(page.getByTestId('ant-ahead')).toHaveAttribute('data-ahead', '1')
    const seen = await where(page).getAttribute('data-at')
    await expect(page.getByTestId('ant-last')).toHaveAttribute('data-to', seen ?? '')
    expect(await stands(race)).toEqual(before)

    await page.getByTestId('step-move').click()
    await expect(page.getByTestId('ant-ahead')).toHaveAttribute('data-ahead', '0')
    await expect(where(page)).toHaveAttribute('data-moves', '3')
    expect(await where(page).getAttribute('data-at')).toBe(seen)
    expect((await race.result(1)).summary?.moves).toBe(3)
  })

  test('is chosen on the map, by pointer and by the cell cursor, and while looking back', async ({
    page,
  }) => {
    const race = await open(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await page.getByTestId('step-move').click()
    await race.menu('lesson-menu', 'lesson-follow')
    await expect(where(page)).toHaveAttribute('data-moves', '1')
    const [x = 0, y = 0] = ((await where(page).getAttribute('data-at')) ?? '')
      .split(',')
      .map(Number)
    const walls = await race.walls()
    const at = await race.pointOf([x, y])
    await page.getByTestId('ant-later').click()
    await page.mouse.click(at.x, at.y)
    await expect(page.getByTestId('ant-number')).not.toHaveValue('2')
    expect(await race.walls()).toBe(walls)

    await page.evaluate(() => window.formicarium.look(1))
    await expect(where(page)).toHaveAttribute('data-iteration', '1')
    await expect(where(page)).toHaveAttribute('data-moves', '0')
    await page.getByTestId('ant-step').click()
    await expect(where(page)).toHaveAttribute('data-moves', '1')
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('ant-card')).toBeHidden()
    await expect(race.stage()).toBeFocused()
  })
})

test('guesses are the same for everybody, and are scored by what could be expected', async ({
  page,
}) => {
  const race = await open(page, { questions: { panel: 0, ant: 2, iteration: 2 } })
  const options = page.getByTestId('guess-option')
  await expect(options.first()).toBeVisible()
  const asked = await options.allInnerTexts()
  await expectClean(page, 'a question')
  await page.locator('body').press('1')
  await expect(page.getByTestId('guess-told')).toBeVisible()
  await expect(page.getByTestId('guess-score')).toHaveAttribute('data-count', '1')
  const yours = Number(await page.getByTestId('guess-score').getAttribute('data-yours'))
  const best = Number(await page.getByTestId('guess-score').getAttribute('data-best'))
  expect(yours).toBeGreaterThan(0)
  expect(best).toBeGreaterThanOrEqual(yours)

  // By pointer: one of the cells around the ant.
  await page.getByTestId('guess-next').click()
  await expect(options.first()).toBeVisible()
  const to = ((await options.first().getAttribute('data-to')) ?? '').split(',').map(Number)
  const at = await race.pointOf([to[0] ?? 0, to[1] ?? 0])
  await page.mouse.click(at.x, at.y)
  await expect(page.getByTestId('guess-score')).toHaveAttribute('data-count', '2')

  await page.getByTestId('guess-again').click()
  await expect.poll(() => options.allInnerTexts()).toEqual(asked)
  await page.getByTestId('guess-card-close').click()
  expect(await lessonOf(race)).toBeUndefined()
})

test.describe('a path by hand', () => {
  test('is dragged, measured and compared, and comes back from its link', async ({ page }) => {
    const race = await open(page)
    await race.menu('lesson-menu', 'lesson-draw')
    await expect(page.getByTestId('draw-card')).toBeVisible()
    await race.drag([
      [0, 0],
      [3, 0],
      [5, 0],
    ])
    await expect(page.getByTestId('draw-standing')).toContainText('Still to come by')
    await race.drag([[4, 2]])
    await expect(page.getByTestId('draw-refusal')).toContainText('(4, 2) is blocked')
    await race.drag([[7, 5]])
    await expect(page.getByTestId('draw-standing')).toContainText('Complete')
    await expect(page.getByTestId('draw-refusal')).toBeHidden()
    await page.getByTestId('draw-label').fill('Class 5b')
    await page.getByTestId('draw-label').press('Enter')
    await expectClean(page, 'the card of a path by hand')
    await expect(page.getByTestId('hand-line').first()).toBeVisible()
    const table = page.locator('table.metrics')
    await expect(table).toContainText('Class 5b')
    const length = Number(await page.getByTestId('metric-length-3').getAttribute('data-value'))
    expect(length).toBeGreaterThanOrEqual(9)
    await expect(page.getByTestId('metric-gap-3')).toHaveAttribute('data-value', /\d/)

    // Pieces are taken back one by one, and drawn again.
    const path = (await lessonOf(race))?.drawn?.path
    await page.getByTestId('draw-undo').click()
    await expect(page.getByTestId('draw-standing')).toContainText('Still to come by')
    await page.getByTestId('draw-redo').click()
    expect((await lessonOf(race))?.drawn?.path).toEqual(path)
    await page.getByTestId('draw-done').click()

    const link = await race.shareLink()
    await race.openAtRest(link)
    expect((await lessonOf(race))?.drawn).toEqual({ label: 'Class 5b', path })
    await expect(table).toContainText('Class 5b')
    await page.reload()
    await race.ready()
    expect((await lessonOf(race))?.drawn).toEqual({ label: 'Class 5b', path })
  })

  test('is drawn with the cell cursor and Enter; a wall in its way makes it no path', async ({
    page,
  }) => {
    const race = await open(page)
    await race.menu('lesson-menu', 'lesson-draw')
    await expect(page.getByTestId('draw-card')).toBeVisible()
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight')
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('draw-standing')).toContainText('5 steps')
    await page.keyboard.press('Control+z')
    await expect.poll(async () => (await lessonOf(race))?.drawn).toBeUndefined()
    await page.keyboard.press('Control+Shift+z')
    await expect.poll(async () => (await lessonOf(race))?.drawn?.path.length).toBe(6)
    await page.keyboard.press('Escape')

    // The map changes: the path is still there, and said to be none.
    await page.locator('body').press('w')
    const at = await race.pointOf([2, 0])
    await page.mouse.click(at.x, at.y)
    await race.menu('lesson-menu', 'lesson-draw')
    await expect(page.getByTestId('draw-standing')).toContainText('is blocked')
  })
})

test('where ground costs more, a path by hand tells the cost that its gap is about', async ({
  page,
}) => {
  const session = small()
  session.scenario.factors = new Float32Array(48).fill(1)
  session.scenario.factors.fill(3, 16, 24)
  const race = new RacePage(page)
  await race.openAtRest(`./#x=${await seal(packBits(session, '0.1.0'))}`)
  await race.menu('lesson-menu', 'lesson-draw')
  await expect(page.getByTestId('draw-card')).toBeVisible()
  const standing = page.getByTestId('draw-standing')
  await expect(standing).toHaveAttribute('role', 'status')
  await race.drag([
    [0, 0],
    [0, 5],
    [7, 5],
  ])
  // Twelve steps of half a metre, of which two are half in ground of factor 3.
  await expect(standing).toContainText(/length 6\.00 m.*Cost 7\.00 m\. .* above the reference/)
})

test('while a path is drawn, undo everywhere is the path’s; afterwards it is the map’s', async ({
  page,
}) => {
  const race = await open(page)
  await race.drag([[2, 2]])
  expect(await race.isWall([2, 2])).toBe(true)
  const undo = page.getByTestId('undo')
  await expect(undo).toHaveAccessibleName('Undo')
  await race.menu('lesson-menu', 'lesson-draw')
  await expect(page.getByTestId('draw-card')).toBeVisible()
  await expect(undo).toHaveAccessibleName('Take the last piece of the path back')
  // Nothing is drawn yet: the wall is not at stake.
  await expect(undo).toBeDisabled()
  await page.locator('body').press('Control+z')
  const steps = page.getByTestId('draw-standing')
  for (const to of [3, 5]) {
    await race.drag([[to, 0]])
    await expect(steps).toContainText(`${to} steps`)
  }
  await undo.click()
  await expect(steps).toContainText('3 steps')
  await page.locator('body').press('Control+z')
  await expect(steps).toBeEmpty()
  await page.getByTestId('redo').click()
  await expect(steps).toContainText('3 steps')
  expect(await race.isWall([2, 2])).toBe(true)
  await page.getByTestId('draw-done').click()
  await expect(undo).toHaveAccessibleName('Undo')
  await undo.click()
  expect(await race.isWall([2, 2])).toBe(false)
  expect((await lessonOf(race))?.drawn?.path.length).toBe(4)
})

test('a target is set in the share dialog, and the page says who has beaten it', async ({
  page,
}) => {
  const race = await open(page)
  await page.getByTestId('share').click()
  await page.getByTestId('target-number').click()
  // The map's cells are half a metre long.
  await expect(page.getByLabel('Number (m)')).toBeVisible()
  await page.getByTestId('target-value').fill('30')
  await page.getByTestId('target-value').press('Tab')
  await expectClean(page, 'the share dialog with a target')
  const field = page.getByTestId('share-link')
  await expect
    .poll(async () => (await lessonOf(race))?.target)
    .toEqual({
      objective: 'length',
      beat: 60,
    })
  await expect(field).toHaveValue(/#x=/)
  await race.leaveDialog()
  const strip = page.getByTestId('target-strip')
  await expect(strip).toHaveAttribute('data-standing', 'nobody')
  await page.getByTestId('run-to-end').click()
  await expect(strip).toHaveAttribute('data-standing', 'beaten')

  await race.openAtRest(await race.shareLink())
  expect((await lessonOf(race))?.target?.beat).toBe(60)
  await page.getByTestId('share').click()
  await page.getByTestId('target-optimum').click()
  await race.leaveDialog()
  await page.getByTestId('run-to-end').click()
  await expect(strip).toHaveAttribute('data-standing', 'reached')
  await page.getByTestId('share').click()
  await page.getByTestId('target-none').click()
  await race.leaveDialog()
  await expect(strip).toBeHidden()
  expect(await lessonOf(race)).toBeUndefined()
})
