import { expect, test } from '@playwright/test'
import { Fingers, RacePage } from './race_page'

test.describe('editing with the mouse', () => {
  test.beforeEach(async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
  })

  test('a fast drag draws a wall without holes; undo and redo take it as one', async ({ page }) => {
    const race = new RacePage(page)
    await race.drag([
      [10, 10],
      [20, 10],
      [20, 15],
    ])
    expect(await race.walls()).toBe(16)
    await page.getByTestId('undo').click()
    expect(await race.walls()).toBe(0)
    await expect(page.getByTestId('redo')).toBeEnabled()
    await page.locator('body').press('Control+Shift+Z')
    expect(await race.walls()).toBe(16)
    await page.locator('body').press('Control+z')
    await page.locator('body').press('Control+y')
    expect(await race.walls()).toBe(16)
  })

  test('the first cell decides: on a wall the drag erases', async ({ page }) => {
    const race = new RacePage(page)
    await race.drag([
      [10, 10],
      [20, 10],
    ])
    await race.drag([
      [15, 10],
      [15, 12],
      [18, 12],
      [18, 10],
    ])
    expect(await race.walls()).toBe(9)
    expect(await race.isWall([15, 12])).toBe(false)
    expect(await race.isWall([16, 10])).toBe(true)
    await page.getByTestId('tool-erase').click()
    await race.drag([
      [5, 10],
      [30, 10],
    ])
    expect(await race.walls()).toBe(0)
  })

  test('start and goal can be dragged with any tool, never onto each other', async ({ page }) => {
    const race = new RacePage(page)
    for (const tool of ['wall', 'erase', 'goal', 'pan']) {
      await page.getByTestId(`tool-${tool}`).click()
      const { spec } = (await race.session()).scenario
      const to: [number, number] = [spec.start[0] + 2, spec.start[1] - 3]
      await race.drag([spec.start, to])
      expect((await race.session()).scenario.spec.start).toEqual(to)
    }
    const { start, goals } = (await race.session()).scenario.spec
    await race.drag([goals[0]?.at ?? [0, 0], start])
    expect((await race.session()).scenario.spec.goals[0]?.at).not.toEqual(start)
    expect(await race.walls()).toBe(0)
  })

  test('start and goal dragged across walls free only the cell they are dropped on', async ({
    page,
  }) => {
    const race = new RacePage(page)
    for (const x of [10, 11, 12]) {
      await race.drag([
        [x, 15],
        [x, 22],
      ])
    }
    const before = (await race.session()).scenario
    expect(before.cells.reduce((sum, cell) => sum + cell, 0)).toBe(24)
    for (const [end, from] of [
      ['start', before.spec.start],
      ['goal', before.spec.goals[0]?.at ?? [0, 0]],
    ] as const) {
      // Slowly, so that it is seen on every wall it passes.
      await race.drag([from, [14, 17], [12, 17], [11, 17], [10, 17], [9, 18], [10, 18], [11, 18]])
      const { spec, cells } = (await race.session()).scenario
      expect(end === 'start' ? spec.start : spec.goals[0]?.at).toEqual([11, 18])
      const expected = before.cells.slice()
      expected[18 * spec.width + 11] = 0
      expect(cells).toEqual(expected)
      await page.getByTestId('undo').click()
      expect((await race.session()).scenario).toEqual(before)
    }
  })

  test('an edit while it plays pauses, begins again and says so', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await race.drag([
      [10, 10],
      [12, 10],
    ])
    await expect(page.getByTestId('play')).toHaveAccessibleName(/play/i)
    await expect(page.getByTestId('toast-info')).toBeVisible()
    await expect.poll(() => race.antMoves()).toBe(0)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('the optimum follows the map', async ({ page }) => {
    const race = new RacePage(page)
    const optimum = async () => Number(await page.getByTestId('optimum').getAttribute('data-value'))
    await expect.poll(optimum).toBeGreaterThan(0)
    const free = await optimum()
    await race.drag([
      [20, 1],
      [20, 23],
    ])
    await expect.poll(optimum).toBeGreaterThan(free)
  })

  test('wheel and middle button look closer; drawing then hits the cell under the pointer', async ({
    page,
  }) => {
    const race = new RacePage(page)
    const at = await race.pointOf([20, 12])
    await page.mouse.move(at.x, at.y)
    await page.keyboard.down('Control')
    for (let i = 0; i < 6; i++) await page.mouse.wheel(0, -200)
    await page.keyboard.up('Control')
    await race.frame()
    await page.mouse.click(at.x, at.y)
    await expect.poll(() => race.isWall([20, 12])).toBe(true)
    await page.mouse.down({ button: 'middle' })
    await page.mouse.move(at.x + 120, at.y + 40)
    await page.mouse.up({ button: 'middle' })
    expect(await race.walls()).toBe(1)
    await race.frame()
    await page.mouse.click(at.x + 120, at.y + 40)
    await expect.poll(() => race.walls()).toBe(0)
    await page.getByTestId('fit').click()
    await race.frame()
    await race.drag([[3, 3]])
    await expect.poll(() => race.isWall([3, 3])).toBe(true)
  })

  test('drawing goes on in the second panel, too', async ({ page }) => {
    const race = new RacePage(page)
    await race.drag(
      [
        [8, 5],
        [8, 9],
      ],
      2,
    )
    expect(await race.walls()).toBe(5)
  })

  test('clear and resize can be undone', async ({ page }) => {
    const race = new RacePage(page)
    await race.drag([
      [10, 10],
      [20, 10],
    ])
    await race.menu('map-menu', 'clear')
    expect(await race.walls()).toBe(0)
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('resize-width').fill('25')
    await page.getByTestId('resize-height').fill('12')
    await race.applyRules()
    const { spec } = (await race.session()).scenario
    expect([spec.width, spec.height]).toEqual([25, 12])
    expect(spec.start[0]).toBeLessThan(25)
    expect(spec.goals[0]?.at[0]).toBeLessThan(25)
    await page.getByTestId('undo').click()
    await page.getByTestId('undo').click()
    expect(await race.walls()).toBe(11)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })
})

test('a size counts as it is typed: with one press on Apply, and with Enter', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const size = async () => {
    const { spec } = (await race.session()).scenario
    return [spec.width, spec.height]
  }
  await race.menu('map-menu', 'open-resize')
  const [width, apply] = [page.getByTestId('resize-width'), page.getByTestId('resize')]
  const type = async (text: string) => {
    await width.click()
    await page.keyboard.press('Control+a')
    await page.keyboard.type(text)
  }
  await type('1')
  await expect(apply).toBeDisabled()
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('resize-dialog')).toBeVisible()
  await type('24')
  await expect(apply).toBeEnabled()
  // Where the finger comes down is where it goes up: nothing has moved between.
  const box = await apply.boundingBox()
  await page.mouse.click((box?.x ?? 0) + 10, (box?.y ?? 0) + 10)
  await expect(page.locator('dialog')).toHaveCount(0)
  expect(await size()).toEqual([24, 22])
  await race.menu('map-menu', 'open-resize')
  await type('30')
  await page.keyboard.press('Enter')
  await expect(page.locator('dialog')).toHaveCount(0)
  expect(await size()).toEqual([30, 22])
})

test.describe('editing with keys', () => {
  test('the cell cursor moves, draws, places, and says what is there', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    const { start } = (await race.session()).scenario.spec
    const said = page.getByTestId('announcement')
    const stage = race.stage()
    await stage.focus()
    await stage.press('ArrowRight')
    await expect(said).toHaveText(/start/i)
    await stage.press('ArrowRight')
    await stage.press('ArrowRight')
    await stage.press('Enter')
    expect(await race.isWall([start[0] + 2, start[1]])).toBe(true)
    await expect(said).toHaveText(/wall/i)
    await stage.press('x')
    expect(await race.walls()).toBe(0)
    await stage.press('s')
    await stage.press('ArrowUp')
    await stage.press('Enter')
    expect((await race.session()).scenario.spec.start).toEqual([start[0] + 2, start[1] - 1])
    await stage.press('g')
    await stage.press('Control+ArrowRight')
    await stage.press('Enter')
    expect((await race.session()).scenario.spec.goals[0]?.at).toEqual([start[0] + 12, start[1] - 1])
    await stage.press('Control+z')
    await stage.press('Control+z')
    expect((await race.session()).scenario.spec.start).toEqual(start)
  })
})

test.describe('editing with fingers', () => {
  test('one finger draws, two move and zoom the map, and a pinch draws nothing @phone', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.stage().scrollIntoViewIfNeeded()
    const before = await race.walls()
    const fingers = await Fingers.on(page)
    const [from, to] = [await race.pointOf([5, 19]), await race.pointOf([11, 19])]
    await fingers.down(from)
    await fingers.move(to)
    await fingers.up()
    await race.frame()
    expect(await race.walls()).toBe(before + 7)
    const centre = await race.pointOf([18, 11])
    const apart = (distance: number) => [
      { x: centre.x - distance, y: centre.y },
      { x: centre.x + distance, y: centre.y },
    ]
    const [first] = apart(20)
    if (!first) return
    // At once: a finger that stays alone for long draws.
    await Promise.all([fingers.down(first), fingers.down(...apart(20))])
    for (const distance of [30, 45, 60]) await fingers.move(...apart(distance))
    await fingers.up()
    await race.frame()
    expect(await race.walls()).toBe(before + 7)
    await page.touchscreen.tap(centre.x, centre.y)
    await race.frame()
    expect(await race.walls()).not.toBe(before + 7)
  })
})
