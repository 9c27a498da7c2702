/** The changes of walls in a session document: read by name, and made on the map that comes with it. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from '../model/cell'
import { limits } from '../model/facts'
import { takenCells } from '../model/goals'
import type { Scenario, WallChange } from '../model/session'
import { changed } from '../model/wall_changes'
import { cell, fieldsOf, integer, invalid, list } from './field_checks'

const MOST_ITERATIONS = 1e7

/** `at` has a number for each of the panels, and none of them goes back. */
export function readChanges(value: unknown, spec: ScenarioSpec, panels: number): WallChange[] {
  const field = 'scenario.changes'
  const changes = list(value, field, limits.max_changes).map((change, i) =>
    readChange(change, `${field}[${i}]`, spec, panels),
  )
  if (changes.length === 0) throw invalid(field, 'must name a change')
  for (const [i, { at }] of changes.entries()) {
    const before = changes[i - 1]?.at ?? []
    const back = at.findIndex((iteration, panel) => iteration < (before[panel] ?? 0))
    if (back >= 0) throw invalid(`${field}[${i}].at[${back}]`, 'is before the change before it')
  }
  return changes
}

function readChange(value: unknown, field: string, spec: ScenarioSpec, panels: number): WallChange {
  const { blocked, freed, at, ...others } = fieldsOf(value, field)
  for (const other of Object.keys(others))
    throw invalid(`${field}.${other}`, 'is no part of a change')
  const cells = (given: unknown, key: string): Cell[] =>
    list(given, `${field}.${key}`, spec.width * spec.height).map((each, i) =>
      cell(each, `${field}.${key}[${i}]`, spec.width, spec.height),
    )
  const iterations = list(at, `${field}.at`, panels).map((each, i) =>
    integer(each, `${field}.at[${i}]`, 0, MOST_ITERATIONS),
  )
  if (iterations.length !== panels)
    throw invalid(`${field}.at`, `has ${iterations.length} numbers for ${panels} panels`)
  return { blocked: cells(blocked, 'blocked'), freed: cells(freed, 'freed'), at: iterations }
}

/** The scenario on the map as all changes leave it; what cannot be changed is refused by name. */
export function afterChanges(scenario: Scenario, changes: WallChange[]): Scenario {
  const { spec, heights } = scenario
  const fixed = new Set(takenCells(spec).map(([x, y]) => y * spec.width + x))
  const make = (cells: Uint8Array, change: WallChange, i: number) => {
    const seen = new Set<number>()
    for (const key of ['blocked', 'freed'] as const) {
      for (const [k, [x, y]] of change[key].entries()) {
        const at = y * spec.width + x
        const was = key === 'blocked' ? 0 : 1
        const known = heights === null || Number.isFinite(heights[at])
        if (fixed.has(at) || seen.has(at) || cells[at] !== was || !known)
          throw invalid(`scenario.changes[${i}].${key}[${k}]`, 'cannot be changed then')
        seen.add(at)
      }
    }
    if (seen.size === 0) throw invalid(`scenario.changes[${i}]`, 'must name a cell')
    return changed(cells, spec.width, change)
  }
  return { ...scenario, cells: changes.reduce(make, scenario.cells) }
}
