/** Whether a robot has room where a path begins and ends, as pure functions. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from './cell'
import { takenCells } from './goals'
import type { Scenario } from './session'
import { keepInside, key } from './settle_ends'
import type { FeltCells } from './tool_calls'

/** Start or goal, whichever first does not fit; null when all do. */
export function withoutRoom(spec: ScenarioSpec, { blocked }: FeltCells): 'start' | 'goal' | null {
  const at = takenCells(spec).findIndex((cell) => blocked[key(cell, spec.width)] === 1)
  return at < 0 ? null : at === 0 ? 'start' : 'goal'
}

/** The ends of the path, those without room moved to the nearest cell that has it; null when there is none. */
export function endsWithRoom(
  spec: ScenarioSpec,
  { blocked }: FeltCells,
): Pick<ScenarioSpec, 'start' | 'goals'> | null {
  const moved = keepInside(spec, (cell) => blocked[cell] === 0)
  return moved && { start: moved.start, goals: moved.goals }
}

/** The largest radius in whole millimetres with which a robot fits at start and goals; without walls there is none. */
export function fittingRadius({ spec, cells }: Scenario): number {
  const room = Math.min(...takenCells(spec).map((end) => roomAt(end, cells, spec.width)))
  return Math.max(0, Math.ceil(room * spec.resolution * 1000) - 1) / 1000
}

/** From the middle of a cell to that of the nearest wall, in cells. */
function roomAt([x, y]: Cell, cells: Uint8Array, width: number): number {
  let least = Number.POSITIVE_INFINITY
  for (let i = 0; i < cells.length; i++) {
    if (cells[i] === 1)
      least = Math.min(least, (x - (i % width)) ** 2 + (y - Math.floor(i / width)) ** 2)
  }
  return Math.sqrt(least)
}
