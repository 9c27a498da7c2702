/** Figures of grids: found, corrected by hand, opened as a map, and planned on. */
import { expect, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { expectClean } from './axe'
import { DRAWN, figurePicture, MARGIN, SIDE } from './figure_picture'
import { Fingers, RacePage } from './race_page'

/** Free and blocked, with the half printed wall as one. */
const KNOWN = DRAWN.flatMap((row) => [...row].map((letter) => Number('#/'.includes(letter))))

/** Where a place of the picture is on the page. */
async function pointAt(page: Page, [x, y]: readonly [number, number]) {
  const pane = page.getByTestId('figure-pane')
  const box = await pane.boundingBox()
  const scale = Number(await pane.getAttribute('data-scale'))
  const [left = 0, top = 0] = ((await pane.getAttribute('data-offset')) ?? '')
    .split(' ')
    .map(Number)
  if (!box) throw new Error('no figure is on screen')
  return { x: box.x + left + x * scale, y: box.y + top + y * scale }
}

const middleOf = ([x, y]: Cell) => [MARGIN + (x + 0.5) * SIDE, MARGIN + (y + 0.5) * SIDE] as const

async function press(page: Page, cell: Cell): Promise<void> {
  const { x, y } = await pointAt(page, middleOf(cell))
  await page.mouse.click(x, y)
}

async function drag(page: Page, places: (readonly [number, number])[]): Promise<void> {
  const points = await Promise.all(places.map((place) => pointAt(page, place)))
  const [first, ...rest] = points
  if (!first) return
  await page.mouse.move(first.x, first.y)
  await page.mouse.down()
  for (const { x, y } of rest) await page.mouse.move(x, y)
  await page.mouse.up()
}

const count = (page: Page, mark: string) => page.getByTestId(`figure-${mark}`)

/** Opens what the dialog shows. */
async function take(page: Page): Promise<void> {
  await page.getByTestId('map-open').click()
  await expect(page.getByTestId('map-dialog')).toBeHidden()
}

async function asFigure(page: Page): Promise<void> {
  await page.getByTestId('map-as-figure').click()
  await expect(page.getByTestId('figure-pane')).toHaveAttribute('aria-busy', 'false')
}

test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

test('a figure is found, corrected by hand, opened and planned on; undo brings the former map back', async ({
  page,
}) => {
  const race = new RacePage(page)
  const before = (await race.session()).scenario
  await race.drop('paper.png', await figurePicture(page))
  await expect(page.getByTestId('figure-offer')).toContainText('12 × 12')
  await asFigure(page)
  await expect(page.getByTestId('figure-size')).toHaveText('12 × 12')
  await expect(count(page, 'unsure')).toHaveText('1')
  await expect(count(page, 'start')).toHaveText('1')
  const walls = KNOWN.filter((cell) => cell === 1).length
  await expect(count(page, 'wall')).toHaveText(String(walls - 1))

  // The unsure cell is told, and becomes a wall by the keyboard.
  await page.getByTestId('figure-next').click()
  await expect(page.getByTestId('figure-pointed')).toContainText('Cell 4, 11: Unsure')
  await page.keyboard.press('Space')
  await expect(count(page, 'unsure')).toHaveText('0')
  await expect(count(page, 'wall')).toHaveText(String(walls))
  await expect(page.getByTestId('figure-next')).toBeDisabled()

  // A wall painted by mistake, over the start too, which stays; and one step back.
  await drag(page, [middleOf([3, 0]), middleOf([0, 0])])
  await expect(count(page, 'wall')).toHaveText(String(walls + 3))
  await expect(count(page, 'start')).toHaveText('1')
  await page.keyboard.press('Control+z')
  await expect(count(page, 'wall')).toHaveText(String(walls))

  // The goal elsewhere, by a press and by the keyboard.
  await page.getByTestId('figure-tool-goal').click()
  await press(page, [9, 11])
  await page.getByTestId('figure-pane').press('ArrowDown')
  await page.getByTestId('figure-pane').press('ArrowRight')
  await page.getByTestId('figure-pane').press('s')
  await take(page)

  const { spec, cells } = (await race.session()).scenario
  expect([spec.width, spec.height, spec.name]).toEqual([12, 12, 'paper'])
  expect([...cells]).toEqual(KNOWN)
  expect([spec.start, spec.goals.map(({ at }) => at)]).toEqual([[1, 0], [[9, 11]]])
  await race.ready()
  await page.locator('body').press('End')
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  await page.locator('body').press('Control+z')
  await expect.poll(async () => (await race.session()).scenario.spec).toEqual(before.spec)
  expect((await race.session()).scenario.cells).toEqual(before.cells)
})

test('where no grid is found, one is set by hand', async ({ page }) => {
  const race = new RacePage(page)
  const rows = ['S....', '.....', '..#..', '.....', '....G']
  await race.drop('bare.png', await figurePicture(page, rows, false))
  await page.getByTestId('map-as-figure').click()
  await expect(page.getByTestId('figure-offer')).toContainText('No grid was found')
  await expect(page.getByTestId('figure-size')).toHaveText('20 × 20')
  await expect(page.getByTestId('figure-tool-lattice')).toHaveAttribute('aria-pressed', 'true')

  // Corners onto the figure, then as many columns and rows as it has.
  const end = MARGIN + 5 * SIDE
  await drag(page, [
    [0, 0],
    [9, 9],
    [MARGIN, MARGIN],
  ])
  await drag(page, [
    [end + MARGIN, end + MARGIN],
    [end + 9, end + 9],
    [end, end],
  ])
  for (const side of ['columns', 'rows']) {
    await page.getByTestId(`figure-${side}`).fill('5')
    await page.getByTestId(`figure-${side}`).press('Enter')
  }
  await expect(page.getByTestId('figure-size')).toHaveText('5 × 5')
  for (const [field, value] of [
    ['x0', MARGIN],
    ['y0', MARGIN],
    ['dx', SIDE],
    ['dy', SIDE],
  ] as const)
    expect(Number(await page.getByTestId(`figure-${field}`).inputValue())).toBeCloseTo(value, 0)
  await expect(count(page, 'wall')).toHaveText('1')
  await page.getByTestId('figure-x0').fill('-40')
  await page.getByTestId('figure-x0').press('Enter')
  await expect(count(page, 'wall')).not.toHaveText('1')
  await page.getByTestId('figure-undo').click()
  await expect(count(page, 'wall')).toHaveText('1')
  await take(page)
  const { spec, cells } = (await race.session()).scenario
  expect([...cells]).toEqual(
    rows.flatMap((row) => [...row].map((letter) => Number(letter === '#'))),
  )
  expect([spec.start, spec.goals[0]?.at]).toEqual([
    [0, 0],
    [4, 4],
  ])
})

test('no figure is opened before its grid is placed, and another grid is told', async ({
  page,
}) => {
  const race = new RacePage(page)
  const open = page.getByTestId('map-open')
  await race.drop(
    'blank.pgm',
    Buffer.concat([Buffer.from('P5\n60 40\n255\n'), Buffer.alloc(2400, 255)]),
  )
  await page.getByTestId('map-as-figure').click()
  await expect(page.getByTestId('figure-why')).toContainText('no grid was found')
  await expect(open).toBeDisabled()
  await page.getByTestId('figure-columns').fill('6')
  await page.getByTestId('figure-columns').press('Tab')
  await expect(open).toBeEnabled()
  await expect(page.getByTestId('figure-why').locator('span')).toBeHidden()
  await page.getByTestId('map-cancel').click()

  await race.drop('paper.png', await figurePicture(page))
  await asFigure(page)
  const said = page.getByTestId('figure-offer')
  await expect(said).toHaveText('A grid of 12 × 12 cells was found.')
  await page.getByTestId('figure-columns').fill('11')
  await page.getByTestId('figure-columns').press('Tab')
  await expect(said).toHaveText('The grid was changed: 11 × 12 cells.')
  await page.getByTestId('figure-undo').click()
  await expect(said).toHaveText('A grid of 12 × 12 cells was found.')
})

test('what cannot be read is refused by name, and a large figure is enlarged and scrolled', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.drop('paper.png', await figurePicture(page))
  await asFigure(page)
  await page.getByTestId('figure-dx').fill('1')
  await page.getByTestId('figure-dx').press('Enter')
  await expect(page.getByTestId('map-dialog')).toContainText('1 × ')
  await expect(page.getByTestId('map-open')).toBeDisabled()
  await page.getByTestId('figure-undo').click()
  await expect(page.getByTestId('map-open')).toBeEnabled()
  const pane = page.getByTestId('figure-pane')
  for (let i = 0; i < 3; i++) await page.getByTestId('figure-larger').click()
  await expect(pane).toHaveAttribute('data-enlarged', 'true')
  await page.getByTestId('figure-next').click()
  // The cell that is told is in sight: its middle lies within the pane.
  await expect(page.getByTestId('figure-pointed')).toContainText('Cell 4, 11')
  await expect
    .poll(async () => {
      const box = await pane.boundingBox()
      const { x, y } = await pointAt(page, middleOf([4, 11]))
      return box && x > box.x && y > box.y && x < box.x + box.width && y < box.y + box.height
    })
    .toBe(true)
  // By pixels, the same picture is a map of pixels.
  await page.getByTestId('map-as-picture').click()
  await expect(page.getByTestId('map-size')).toContainText(`${12 * SIDE + 2 * MARGIN} × `)
})

for (const scheme of ['light', 'dark'] as const)
  test(`axe finds nothing serious in the dialog of a figure (${scheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme })
    await new RacePage(page).drop('paper.png', await figurePicture(page))
    await asFigure(page)
    await expectClean(page, 'figure')
  })

test('a tap corrects a cell, and of what is enlarged a finger scrolls @phone', async ({ page }) => {
  await new RacePage(page).drop('paper.png', await figurePicture(page))
  await asFigure(page)
  const walls = KNOWN.filter((cell) => cell === 1).length
  const fingers = await Fingers.on(page)
  await fingers.down(await pointAt(page, middleOf([2, 0])))
  await fingers.up()
  await expect(count(page, 'wall')).toHaveText(String(walls))
  for (let i = 0; i < 4; i++) await page.getByTestId('figure-larger').click()
  const box = await page.getByTestId('figure-pane').boundingBox()
  if (!box) throw new Error('no figure is on screen')
  const from = { x: box.x + 200, y: box.y + 250 }
  await fingers.down(from)
  for (let y = 20; y <= 160; y += 20) await fingers.move({ x: from.x, y: from.y - y })
  await fingers.up()
  const scrolled = () =>
    page.getByTestId('figure-scroller').evaluate((scroller) => scroller.scrollTop)
  await expect.poll(scrolled).toBeGreaterThan(50)
  await expect(count(page, 'wall')).toHaveText(String(walls))
  await expect(page.getByTestId('figure-undo')).toBeEnabled()
})
