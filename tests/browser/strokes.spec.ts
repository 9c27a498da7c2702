/** Walls come to be exactly under the finger, on every screen: nothing on the page moves while one draws. */
import { expect, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { lineCells } from '../../www/src/model/edit'
import { Fingers, RacePage } from './race_page'

const SCREENS = [
  [667, 375],
  [844, 390],
  [932, 430],
  [320, 568],
  [360, 640],
  [390, 844],
  [768, 1024],
] as const

/** Corners of a stroke about the middle of the open field, so that they are in sight on low screens. */
const STROKE: Cell[] = [
  [15, 11],
  [22, 11],
  [22, 13],
  [17, 13],
]

for (const [width, height] of SCREENS)
  for (const running of [false, true])
    test(`a finger draws where it is, ${running ? 'while it runs' : 'at rest'}, on ${width} × ${height} @phone`, async ({
      page,
    }) => {
      await page.setViewportSize({ width, height })
      const race = new RacePage(page)
      await race.openAtRest()
      await race.menu('map-menu', 'gallery-open-field')
      await expect.poll(() => race.walls()).toBe(0)
      if (running) {
        await page.getByTestId('play').click()
        await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
      }
      const stage = race.stage()
      await stage.evaluate((element) => element.scrollIntoView({ block: 'center' }))
      const points = []
      for (const cell of STROKE) points.push(await race.pointOf(cell))
      for (const { x, y } of points)
        expect(
          await page.evaluate(
            ([left = 0, top = 0]) =>
              document.elementFromPoint(left, top)?.closest('.stage') !== null,
            [x, y],
          ),
          'nothing lies over the map there',
        ).toBe(true)
      const before = await stage.boundingBox()
      const fingers = await Fingers.on(page)
      const [first, ...rest] = points
      if (!first) return
      await fingers.down(first)
      for (const point of rest) {
        await fingers.move(point)
        for (let i = 0; i < 4; i++) await race.frame()
        expect(await stage.boundingBox(), 'nothing moves under the finger').toEqual(before)
      }
      await fingers.up()
      await race.frame()
      const { spec, cells } = (await race.session()).scenario
      const expected = new Set(
        STROKE.slice(1).flatMap((to, i) => lineCells(STROKE[i] ?? to, to).map(String)),
      )
      const walls = [...cells.keys()]
        .filter((cell) => cells[cell] === 1)
        .map((cell) => String([cell % spec.width, Math.floor(cell / spec.width)]))
      expect(walls.sort()).toEqual([...expected].sort())
    })

test('while one draws, the picture follows and the page waits; then it begins anew @phone', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await page.getByTestId('play').click()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  await race.stage().evaluate((element) => element.scrollIntoView({ block: 'center' }))
  const fingers = await Fingers.on(page)
  const [from, to] = [await race.pointOf([15, 11]), await race.pointOf([20, 11])]
  await fingers.down(from)
  await fingers.move(to)
  for (let i = 0; i < 10; i++) await race.frame()
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'running')
  expect(await race.walls()).toBe(0)
  await fingers.up()
  await expect.poll(() => race.walls()).toBe(6)
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
  await expect(page.getByTestId('toast-info')).toBeVisible()
})
