/** Tools that draw more than one cell after the other, or take up a part of the map: by mouse, keys and fingers. */
import { expect, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { Fingers, RacePage } from './race_page'

/** The open field, empty and at rest, with the further tools in their place. */
async function openField(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await expect(page.getByTestId('tool-select')).toBeVisible()
  return race
}

/** Walls as columns and rows. */
async function walls(race: RacePage): Promise<string[]> {
  const { spec, cells } = (await race.session()).scenario
  const at = (cell: number) => `${cell % spec.width},${Math.floor(cell / spec.width)}`
  return [...cells.keys()].filter((cell) => cells[cell] === 1).map(at)
}

/** What a list of cells reads as. */
const listed = (cells: Cell[]) =>
  [...cells].sort(([ax, ay], [bx, by]) => ay - by || ax - bx).map((cell) => cell.join())

const block = (x: number, y: number, width: number, height: number): Cell[] =>
  Array.from({ length: width * height }, (_, i) => [x + (i % width), y + Math.floor(i / width)])

test.describe('with the mouse', () => {
  test('line, rectangle, filled rectangle and fill, each one step to undo', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('l')
    await page.keyboard.down('Shift')
    await race.drag([
      [5, 5],
      [11, 6],
    ])
    await page.keyboard.up('Shift')
    expect(await walls(race)).toEqual(listed(block(5, 5, 7, 1)))
    await page.getByTestId('undo').click()
    expect(await race.walls()).toBe(0)

    await page.keyboard.press('b')
    await race.drag([
      [14, 12],
      [10, 8],
      [10, 9],
    ])
    const border = block(10, 9, 5, 4).filter(
      ([x, y]) => x === 10 || x === 14 || y === 9 || y === 12,
    )
    expect(await walls(race)).toEqual(listed(border))

    await page.keyboard.press('d')
    await race.drag([[12, 10]])
    expect(await walls(race)).toEqual(listed(block(10, 9, 5, 4)))
    await page.getByTestId('undo').click()
    expect(await walls(race)).toEqual(listed(border))
    // On a wall it tears down all that hangs together.
    await race.drag([[10, 9]])
    expect(await race.walls()).toBe(0)

    await page.keyboard.press('n')
    await race.drag([
      [20, 5],
      [22, 8],
    ])
    expect(await walls(race)).toEqual(listed(block(20, 5, 3, 4)))
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('tool-wall')).toHaveAttribute('aria-pressed', 'true')
  })

  test('a wide brush draws and erases, start and goals stay free', async ({ page }) => {
    const race = await openField(page)
    await page.getByTestId('brush-size').click()
    await page.getByTestId('size-3').click()
    await race.drag([
      [20, 10],
      [23, 10],
    ])
    expect(await walls(race)).toEqual(listed(block(19, 9, 6, 3)))
    await page.keyboard.press('e')
    await race.drag([[20, 10]])
    expect(await walls(race)).toEqual(listed(block(22, 9, 3, 3)))
    await page.getByTestId('undo').click()
    await page.getByTestId('undo').click()
    await page.keyboard.press('w')
    await race.drag([
      [6, 19],
      [3, 19],
    ])
    const { start } = (await race.session()).scenario.spec
    expect(await race.isWall(start)).toBe(false)
    expect(await race.isWall([start[0] + 1, start[1]])).toBe(true)
  })

  test('one button stands for what draws walls, and remembers the last', async ({ page }) => {
    await openField(page)
    const button = page.getByTestId('tool-wall')
    await button.click()
    await expect(page.getByTestId('shape-line')).toBeVisible()
    await expect(page.getByTestId('shape-wall')).toBeFocused()
    await page.keyboard.press('ArrowDown')
    await page.keyboard.press('Enter')
    await expect(button).toHaveAccessibleName(/line/i)
    await page.getByTestId('tool-pan').click()
    await button.click()
    await expect(page.getByTestId('shape-line')).toBeHidden()
    await expect(button).toHaveAttribute('aria-pressed', 'true')
    await button.click()
    await expect(page.getByTestId('shape-line')).toHaveAttribute('aria-checked', 'true')
    await button.click()
    await expect(page.getByTestId('shape-line')).toBeHidden()
  })

  test('the list opens though it has not been fetched yet', async ({ page }) => {
    const race = new RacePage(page)
    // The whole engine never comes, and with it no idle moment; the core is the first of the two.
    let engines = 0
    await page.route(/formicarium_bg.*wasm/, async (route) => {
      engines += 1
      if (engines === 1) await route.continue()
    })
    await race.open()
    await page.getByTestId('tool-wall').click()
    await expect(page.getByTestId('shape-fill')).toBeVisible()
  })

  test('a selection is moved and copied; what it covered comes back when it moves on', async ({
    page,
  }) => {
    const race = await openField(page)
    await page.keyboard.press('n')
    await race.drag([
      [10, 5],
      [11, 6],
    ])
    await race.drag([
      [16, 5],
      [16, 9],
    ])
    await page.keyboard.press('m')
    await race.drag([
      [9, 4],
      [12, 7],
    ])
    await race.drag([
      [10, 5],
      [15, 6],
    ])
    // Its free edge covers the column at 16, all but the end.
    expect(await walls(race)).toEqual(listed([...block(15, 6, 2, 2), [16, 9]]))
    await race.drag([
      [16, 6],
      [26, 6],
    ])
    expect(await walls(race)).toEqual(listed([...block(25, 6, 2, 2), ...block(16, 5, 1, 5)]))
    await page.keyboard.down('Control')
    await race.drag([
      [25, 6],
      [25, 12],
    ])
    await page.keyboard.up('Control')
    const copied = [...block(25, 6, 2, 2), ...block(25, 12, 2, 2), ...block(16, 5, 1, 5)]
    expect(await walls(race)).toEqual(listed(copied))
    await page.getByTestId('undo').click()
    // Moving on and on is one step.
    await page.getByTestId('undo').click()
    expect(await walls(race)).toEqual(listed([...block(10, 5, 2, 2), ...block(16, 5, 1, 5)]))
  })

  test('a handle makes the selection larger, a click beside it drops it', async ({ page }) => {
    const race = await openField(page)
    const said = page.getByTestId('announcement')
    await page.keyboard.press('m')
    await race.drag([
      [10, 5],
      [14, 8],
    ])
    await expect(said).toHaveText(/5 by 4 cells selected from 10, 5/i)
    const [inner, beyond] = [await race.pointOf([14, 8]), await race.pointOf([15, 9])]
    const to = await race.pointOf([20, 12])
    await page.mouse.move((inner.x + beyond.x) / 2, (inner.y + beyond.y) / 2)
    await page.mouse.down()
    await page.mouse.move(to.x, to.y)
    await page.mouse.up()
    await expect(said).toHaveText(/11 by 8 cells selected from 10, 5/i)
    await race.drag([[30, 20]])
    await expect(said).toHaveText(/nothing is selected/i)
    expect(await race.walls()).toBe(0)
  })

  test('walls of a selection never cover the start, and that is said', async ({ page }) => {
    const race = await openField(page)
    const { start } = (await race.session()).scenario.spec
    await page.keyboard.press('n')
    await race.drag([
      [start[0] + 4, start[1]],
      [start[0] + 6, start[1]],
    ])
    await page.keyboard.press('m')
    await race.drag([
      [start[0] + 4, start[1]],
      [start[0] + 6, start[1]],
    ])
    await race.drag([
      [start[0] + 5, start[1]],
      [start[0], start[1]],
    ])
    expect(await walls(race)).toEqual(
      listed([
        [start[0] - 1, start[1]],
        [start[0] + 1, start[1]],
      ]),
    )
    await expect(page.getByTestId('toast-info')).toContainText(/start and goals stay free/i)
  })

  test('the whole map is turned and mirrored, with start and goal', async ({ page }) => {
    const race = await openField(page)
    await race.drag([
      [3, 2],
      [8, 2],
    ])
    const before = (await race.session()).scenario
    await page.keyboard.press('m')
    await race.menu('tool-select', 'turn-right')
    const { spec } = (await race.session()).scenario
    expect([spec.width, spec.height]).toEqual([25, 40])
    expect(spec.start).toEqual([24 - before.spec.start[1], before.spec.start[0]])
    expect(await walls(race)).toEqual(listed(block(22, 3, 1, 6)))
    // Drawing meets the cell under the pointer on the map as it is now.
    await page.keyboard.press('w')
    await race.drag([[2, 30]])
    expect(await race.isWall([2, 30])).toBe(true)
    await page.getByTestId('undo').click()
    await page.getByTestId('undo').click()
    expect((await race.session()).scenario).toEqual(before)
    await page.keyboard.press('m')
    await race.menu('tool-select', 'turn-mirror')
    expect(await walls(race)).toEqual(listed(block(31, 2, 6, 1)))
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('a map that is crossed by slices cannot be turned, and that is said', async ({ page }) => {
    const race = await openField(page)
    await race.menu('map-menu', 'gallery-terrain-slices')
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(21)
    const before = (await race.session()).scenario
    await page.keyboard.press('m')
    await race.menu('tool-select', 'turn-left')
    await expect(page.getByTestId('toast-warning')).toContainText(/slices/i)
    expect((await race.session()).scenario).toEqual(before)
    await race.menu('tool-select', 'turn-flip')
    const after = (await race.session()).scenario
    expect(after.spec.start[1]).toBe(20 - before.spec.start[1])
    expect(after.heights?.[20 * 21]).toBe(before.heights?.[0])
    await race.ready()
  })
})

test.describe('with keys', () => {
  test('two corners make a line; Escape leaves it out', async ({ page }) => {
    const race = await openField(page)
    const { start } = (await race.session()).scenario.spec
    const said = page.getByTestId('announcement')
    const stage = race.stage()
    await stage.focus()
    await stage.press('l')
    await stage.press('ArrowRight')
    await stage.press('ArrowUp')
    await stage.press('Enter')
    await expect(said).toHaveText(/line from/i)
    await stage.press('Escape')
    await expect(said).toHaveText(/left out/i)
    await stage.press('Enter')
    await stage.press('Control+ArrowRight')
    await stage.press('Enter')
    await expect(said).toHaveText(/11 cells/i)
    expect(await walls(race)).toEqual(listed(block(start[0], start[1] - 1, 11, 1)))
    await stage.press('Control+z')
    expect(await race.walls()).toBe(0)
    await stage.press('w')
    await stage.press('k')
    await stage.press('k')
    await expect(said).toHaveText(/3 cells/i)
    await stage.press('Enter')
    expect(await race.walls()).toBe(9)
    await stage.press('d')
    await stage.press('x')
    expect(await race.walls()).toBe(0)
  })

  test('a selection is made, nudged, copied, cut, pasted and freed', async ({ page }) => {
    const race = await openField(page)
    const said = page.getByTestId('announcement')
    await page.keyboard.press('n')
    await race.drag([
      [10, 10],
      [11, 11],
    ])
    const stage = race.stage()
    await stage.focus()
    await page.mouse.move(2, 2)
    await stage.press('m')
    const { start } = (await race.session()).scenario.spec
    await stage.press('ArrowRight')
    // From the start to the block.
    for (let y = start[1]; y > 11; y--) await stage.press('ArrowUp')
    for (let x = start[0]; x < 10; x++) await stage.press('ArrowRight')
    await stage.press('Enter')
    await stage.press('ArrowUp')
    await stage.press('ArrowRight')
    await stage.press('Enter')
    await expect(said).toHaveText(/2 by 2 cells selected/i)
    await stage.press('ArrowRight')
    await stage.press('ArrowRight')
    await stage.press('ArrowDown')
    expect(await walls(race)).toEqual(listed(block(12, 11, 2, 2)))
    await stage.press('Control+c')
    await stage.press('Control+v')
    await stage.press('Control+ArrowRight')
    expect(await walls(race)).toEqual(listed([...block(12, 11, 2, 2), ...block(22, 11, 2, 2)]))
    await stage.press('Control+x')
    expect(await walls(race)).toEqual(listed(block(12, 11, 2, 2)))
    await stage.press('Control+a')
    await stage.press('Delete')
    expect(await race.walls()).toBe(0)
    await stage.press('Escape')
    await expect(said).toHaveText(/nothing is selected/i)
    await stage.press('Control+z')
    expect(await race.walls()).toBe(4)
  })
})

test.describe('with fingers', () => {
  test('shapes, fill and selections; a pinch draws nothing @phone', async ({ page }) => {
    const race = await openField(page)
    await race.stage().evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const fingers = await Fingers.on(page)
    const swipe = async (from: Cell, to: Cell) => {
      await fingers.down(await race.pointOf(from))
      await fingers.move(await race.pointOf(to))
      await fingers.up()
      await race.frame()
    }
    await page.getByTestId('tool-wall').tap()
    await page.getByTestId('shape-rectangle').tap()
    await swipe([10, 8], [15, 12])
    expect(await race.walls()).toBe(18)
    await page.getByTestId('tool-wall').tap()
    await page.getByTestId('shape-fill').tap()
    await swipe([12, 10], [12, 10])
    expect(await walls(race)).toEqual(listed(block(10, 8, 6, 5)))

    // Without a Shift key lines are kept straight by a switch beside the tool, which takes up the line.
    await page.getByTestId('tool-wall').tap()
    await page.getByTestId('shape-straight').tap()
    await swipe([20, 4], [26, 5])
    await swipe([20, 6], [24, 9])
    const slanted: Cell[] = [0, 1, 2, 3, 4].map((i) => [20 + i, 6 + i])
    const straight = [...block(20, 4, 7, 1), ...slanted]
    expect(await walls(race)).toEqual(listed([...block(10, 8, 6, 5), ...straight]))
    for (let i = 0; i < 2; i++) await page.getByTestId('undo').tap()
    await page.getByTestId('tool-wall').tap()
    await expect(page.getByTestId('shape-straight')).toHaveAttribute('aria-checked', 'true')
    await page.getByTestId('shape-straight').tap()
    await swipe([20, 4], [26, 6])
    expect(await walls(race)).not.toContainEqual('26,4')
    await page.getByTestId('undo').tap()

    const centre = await race.pointOf([20, 11])
    const apart = (distance: number) => [
      { x: centre.x - distance, y: centre.y },
      { x: centre.x + distance, y: centre.y },
    ]
    await Promise.all([fingers.down(centre), fingers.down(...apart(20))])
    await fingers.move(...apart(40))
    await fingers.up()
    await race.frame()
    expect(await race.walls()).toBe(30)
    await page.getByTestId('fit').tap()

    await race.stage().evaluate((element) => element.scrollIntoView({ block: 'center' }))
    await page.getByTestId('tool-select').tap()
    await swipe([9, 7], [16, 13])
    await swipe([12, 10], [20, 12])
    expect(await walls(race)).toEqual(listed(block(18, 10, 6, 5)))
    await page.getByTestId('tool-select').tap()
    await page.getByTestId('turn-left').tap()
    expect(await walls(race)).toEqual(listed(block(18, 9, 5, 6)))
    await page.getByTestId('tool-select').tap()
    await page.getByTestId('selection-free').tap()
    expect(await race.walls()).toBe(0)
  })

  test('every tool can be reached, as large as a finger @phone', async ({ page }) => {
    await openField(page)
    for (const id of ['wall', 'erase', 'select', 'start', 'goal', 'add-goal', 'inspect', 'pan']) {
      const button = page.getByTestId(`tool-${id}`)
      await button.scrollIntoViewIfNeeded()
      await button.tap()
      await expect(button).toHaveAttribute('aria-pressed', 'true')
      const box = await button.boundingBox()
      expect(Math.min(box?.width ?? 0, box?.height ?? 0), id).toBeGreaterThanOrEqual(40)
    }
    await expect(page.getByTestId('undo')).toBeInViewport()
  })
})
