/** What moves while a robot drives, as pure functions of the scenario. */
import type { DriveSpec, Track } from '@pkg/formicarium'
import type { Cell } from './cell'
import { isInside, lineCells, sameCell } from './edit'
import { isGoal } from './goals'
import type { Scenario } from './session'
import { changed } from './wall_changes'

/** Both lists are there, whatever the scenario leaves out. */
export type Moving = DriveSpec & Required<Pick<DriveSpec, 'changes' | 'tracks'>>
export type Walls = Moving['changes'][number] & { blocked: Cell[]; freed: Cell[] }

export function movingOf({ spec }: Scenario): Moving {
  return { ...spec.drive, changes: spec.drive?.changes ?? [], tracks: spec.drive?.tracks ?? [] }
}

export const isStill = (moving: Moving) =>
  moving.changes.length === 0 && moving.tracks.length === 0 && moving.sight === undefined

/** The same map with other things that move; where nothing does, as if there never had been. */
export function withMoving(scenario: Scenario, moving: Moving): Scenario {
  const { drive: _, ...spec } = scenario.spec
  return { ...scenario, spec: isStill(moving) ? spec : { ...spec, drive: moving } }
}

export const newTrack = (cells: Cell[]): Track => ({
  cells,
  size: 1,
  from_step: 0,
  steps_per_cell: 1,
  at_end: 'back-and-forth',
})

/** A track that goes straight on to a cell, as far as it lies on the map. */
export function trackTo(track: Track, to: Cell, scenario: Scenario): Track {
  const last = track.cells.at(-1)
  const way = (last ? lineCells(last, to).slice(1) : [to]).filter((cell) =>
    isInside(scenario, cell),
  )
  return way.length === 0 ? track : { ...track, cells: [...track.cells, ...way] }
}

/** The map as changes leave it, one after the other. */
export function cellsAfter(scenario: Scenario, changes: Moving['changes']): Uint8Array {
  const make = (cells: Uint8Array, change: Moving['changes'][number]) =>
    changed(cells, scenario.spec.width, full(change))
  return changes.reduce(make, scenario.cells)
}

export const full = (change: Moving['changes'][number]): Walls => ({
  ...change,
  blocked: change.blocked ?? [],
  freed: change.freed ?? [],
})

/** Whether a wall can come to stand on a cell, or leave it, on the map as changes before have left it. */
function fits(scenario: Scenario, before: Uint8Array, block: boolean, cell: Cell): boolean {
  if (!isInside(scenario, cell)) return false
  const at = cell[1] * scenario.spec.width + cell[0]
  if (block) return before[at] === 0 && !isGoal(scenario, cell)
  return before[at] === 1 && Number.isFinite(scenario.heights?.[at] ?? 0)
}

/** Adds cells to a change of walls, or takes them out; those that do not fit are left as they are. */
export function brushed(
  scenario: Scenario,
  index: number,
  cells: Cell[],
  paint: 'block' | 'free' | 'leave',
): Moving {
  const moving = movingOf(scenario)
  const before = cellsAfter(scenario, moving.changes.slice(0, index))
  const other = (of: Cell) => !cells.some((cell) => sameCell(cell, of))
  const added = (block: boolean) =>
    paint === (block ? 'block' : 'free')
      ? cells.filter((cell) => fits(scenario, before, block, cell))
      : []
  const brush = (change: Walls): Walls => ({
    ...change,
    blocked: [...change.blocked.filter(other), ...added(true)],
    freed: [...change.freed.filter(other), ...added(false)],
  })
  return {
    ...moving,
    changes: moving.changes.map((change, i) => (i === index ? brush(full(change)) : change)),
  }
}

/** Those cells of all changes that fit, changes that are left without any dropped. */
export function wallsThatFit(scenario: Scenario): Moving['changes'] {
  const kept: Walls[] = []
  for (const change of movingOf(scenario).changes) {
    const before = cellsAfter(scenario, kept)
    const { blocked, freed, at_step } = full(change)
    const fit = {
      at_step,
      blocked: blocked.filter((cell) => fits(scenario, before, true, cell)),
      freed: freed.filter((cell) => fits(scenario, before, false, cell)),
    }
    if (fit.blocked.length + fit.freed.length > 0) kept.push(fit)
  }
  return kept
}

/** The same on a map whose cells have other places. */
export function movingAfter(drive: DriveSpec, placeOf: (cell: Cell) => Cell): DriveSpec {
  const { changes = [], tracks = [] } = drive
  return {
    ...drive,
    changes: changes.map(full).map(({ at_step, blocked, freed }) => ({
      at_step,
      blocked: blocked.map(placeOf),
      freed: freed.map(placeOf),
    })),
    tracks: tracks.map((track) => ({ ...track, cells: track.cells.map(placeOf) })),
  }
}

/** A refused part taken out, as the field of a refusal names it; null where it names none. */
export function without(moving: Moving, field: string): Moving | null {
  const [, list, index] = /^drive\.(tracks|changes)(?:\[(\d+)\])?/.exec(field) ?? []
  if (field.startsWith('drive.sight')) {
    const { sight: _, ...rest } = moving
    return rest
  }
  if (list !== 'tracks' && list !== 'changes') return null
  const keep = (_: unknown, i: number) => index !== undefined && i !== Number(index)
  return list === 'tracks'
    ? { ...moving, tracks: moving.tracks.filter(keep) }
    : { ...moving, changes: moving.changes.filter(keep) }
}

/** How far one can go straight on from a cell without a wall, at most so many cells. */
function reach(scenario: Scenario, [x, y]: Cell, [dx, dy]: Cell, most: number): Cell[] {
  const way: Cell[] = []
  for (let i = 1; i <= most; i++) {
    const cell: Cell = [x + i * dx, y + i * dy]
    if (!isInside(scenario, cell)) break
    if (scenario.cells[cell[1] * scenario.spec.width + cell[0]] === 1) break
    way.push(cell)
  }
  return way
}

/** Cells to either side of a path that an obstacle of the example comes from. */
const ASIDE = 4

/**
 * An obstacle that crosses a path, near its middle, where there is most room beside it. Where there is none, one that stands in the way
 * for a while and leaves along it. Null for a path that is too short.
 */
export function crossing(scenario: Scenario, path: Cell[]): Track | null {
  let best: Cell[] = []
  const from = Math.floor(path.length / 3)
  for (let i = Math.max(1, from); i < path.length - Math.max(1, from); i++) {
    const [at, next] = [path[i], path[i + 1]]
    if (!at || !next) continue
    const [dx, dy] = [next[0] - at[0], next[1] - at[1]]
    const side = (sign: number) => reach(scenario, at, [-sign * dy, sign * dx], ASIDE)
    const way = [...side(1).reverse(), at, ...side(-1)]
    if (way.length > best.length) best = way
  }
  if (best.length > 2) return { ...newTrack(best), steps_per_cell: 2 }
  const along = path.slice(from, from + 3)
  return along.length < 2 || path.length < 5
    ? null
    : { ...newTrack(along.reverse()), steps_per_cell: 4, at_end: 'leave' }
}
