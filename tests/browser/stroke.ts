/** One stroke on the map, and the walls that must come of it: the same in every browser. */
import { expect } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { lineCells } from '../../www/src/model/edit'
import type { Point, Race } from './race'

/** Windows of phones and tablets: width and height. */
export const SCREENS = [
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

/** What draws. */
export interface Finger {
  down(point: Point): Promise<void>
  move(point: Point): Promise<void>
  up(): Promise<void>
}

/** From a page at rest: draws on the open field, and walls are exactly where the finger was. */
export async function drawsWhereItIs(race: Race, finger: Finger, running: boolean): Promise<void> {
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  if (running) {
    await race.press('play')
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  }
  await race.toMiddle()
  const points = []
  for (const cell of STROKE) points.push(await race.pointOf(cell))
  for (const point of points)
    expect(await liesOnMap(race, point), 'nothing lies over the map there').toBe(true)
  const before = await race.box()
  const [first, ...rest] = points
  if (!first) return
  await finger.down(first)
  for (const point of rest) {
    await finger.move(point)
    for (let i = 0; i < 4; i++) await race.frame()
    expect(await race.box(), 'nothing moves under the finger').toEqual(before)
  }
  await finger.up()
  await race.frame()
  expect(await wallsOf(race)).toEqual(expectedWalls())
}

function liesOnMap(race: Race, point: Point): Promise<boolean> {
  return race.evaluate(
    ({ x, y }) => Boolean(document.elementFromPoint(x, y)?.closest('.stage')),
    point,
  )
}

async function wallsOf(race: Race): Promise<string[]> {
  const { spec, cells } = (await race.session()).scenario
  return [...cells.keys()]
    .filter((cell) => cells[cell] === 1)
    .map((cell) => String([cell % spec.width, Math.floor(cell / spec.width)]))
    .sort()
}

function expectedWalls(): string[] {
  const lines = STROKE.slice(1).flatMap((to, i) => lineCells(STROKE[i] ?? to, to).map(String))
  return [...new Set(lines)].sort()
}
