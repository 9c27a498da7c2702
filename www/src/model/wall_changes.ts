/** Walls that change while runs go on, as pure functions. */
import type { Cell } from './cell'
import type { Scenario, Session, WallChange } from './session'

type Walls = Pick<WallChange, 'blocked' | 'freed'>

/** Cells with a change made. */
export function changed(cells: Uint8Array, width: number, { blocked, freed }: Walls): Uint8Array {
  const after = cells.slice()
  for (const [x, y] of blocked) after[y * width + x] = 1
  for (const [x, y] of freed) after[y * width + x] = 0
  return after
}

/** Cells before changes that have led to these. */
export function cellsBefore(cells: Uint8Array, width: number, changes: Walls[]): Uint8Array {
  const undo = (after: Uint8Array, { blocked, freed }: Walls) =>
    changed(after, width, { blocked: freed, freed: blocked })
  return changes.reduceRight(undo, cells)
}

/** The session's scenario on the map with which its runs began. */
export function scenarioBefore({ scenario, changes = [] }: Session): Scenario {
  const { spec, cells } = scenario
  return changes.length === 0
    ? scenario
    : { ...scenario, cells: cellsBefore(cells, spec.width, changes) }
}

/** What leads from one map to another of the same size, row by row from the upper left. */
export function wallsBetween(before: Uint8Array, after: Uint8Array, width: number): Walls {
  const blocked: Cell[] = []
  const freed: Cell[] = []
  for (let i = 0; i < after.length; i++) {
    if (after[i] === before[i]) continue
    const list = after[i] === 1 ? blocked : freed
    list.push([i % width, Math.floor(i / width)])
  }
  return { blocked, freed }
}
