/** A whole map turned by a quarter, or mirrored: with start and goals, heights, factors, and its place in the world where that can be said. */
import type { World } from '@pkg/formicarium'
import type { Cell } from './cell'
import { movingAfter } from './moving'
import type { Scenario } from './session'
import type { Sides } from './spans'
import { pointOf } from './world'

/** A quarter to the left or right · left and right swapped · above and below swapped */
export type Turn = 'left' | 'right' | 'mirror' | 'flip'

export const TURNS: readonly Turn[] = ['left', 'right', 'mirror', 'flip']

export const isQuarter = (turn: Turn) => turn === 'left' || turn === 'right'

export function sidesAfter({ width, height }: Sides, turn: Turn): Sides {
  return isQuarter(turn) ? { width: height, height: width } : { width, height }
}

/** Where a cell of something as large as this goes. */
export function placeAfter([x, y]: Cell, { width, height }: Sides, turn: Turn): Cell {
  switch (turn) {
    case 'left':
      return [y, width - 1 - x]
    case 'right':
      return [height - 1 - y, x]
    case 'mirror':
      return [width - 1 - x, y]
    case 'flip':
      return [x, height - 1 - y]
  }
}

/** Why a map cannot be turned: by slices one goes from column to column, which turned would be another question. */
export function turnRefused({ spec }: Scenario, turn: Turn): boolean {
  return isQuarter(turn) && !!spec.terrain?.slices
}

/** Every cell keeps its place in the world when the map is turned; a mirrored map has no place there, so that it is left out. */
export function turnMap(scenario: Scenario, turn: Turn): Scenario {
  const { spec, cells, heights, factors } = scenario
  const sides = sidesAfter(spec, turn)
  const { world, drive, ...rest } = spec
  const placed = world && isQuarter(turn) ? { world: turnedWorld(scenario, world, turn) } : {}
  return {
    spec: {
      ...rest,
      ...placed,
      ...(drive && { drive: movingAfter(drive, (cell) => placeAfter(cell, spec, turn)) }),
      ...sides,
      start: placeAfter(spec.start, spec, turn),
      goals: spec.goals.map((goal) => ({ ...goal, at: placeAfter(goal.at, spec, turn) })),
    },
    cells: moved(cells, new Uint8Array(cells.length), spec, turn),
    heights: heights && moved(heights, new Float32Array(heights.length), spec, turn),
    factors: factors && moved(factors, new Float32Array(factors.length), spec, turn),
    origin: null,
  }
}

function moved<T extends Uint8Array | Float32Array>(from: T, onto: T, map: Sides, turn: Turn): T {
  const { width } = sidesAfter(map, turn)
  for (let y = 0; y < map.height; y++)
    for (let x = 0; x < map.width; x++) {
      const at = placeAfter([x, y], map, turn)
      onto[at[1] * width + at[0]] = from[y * map.width + x] ?? 0
    }
  return onto
}

/** Turned to the left the upper left corner becomes the lower left one, to the right the lower right corner does. */
function turnedWorld({ spec }: Scenario, world: World, turn: Turn): World {
  const { width, height, resolution } = spec
  const left = turn === 'left'
  const [x, y] = left
    ? pointOf(world, 0, height * resolution)
    : pointOf(world, width * resolution, 0)
  const yaw = (world.yaw ?? 0) + (left ? -Math.PI / 2 : Math.PI / 2)
  return { ...world, x, y, yaw: Math.atan2(Math.sin(yaw), Math.cos(yaw)) }
}
