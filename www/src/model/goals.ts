/** The goals of a scenario: placed, changed, removed and named. Pure, as all edits are. */
import type { Goal, ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from './cell'
import { limits } from './facts'
import { goalAt, type Scenario } from './session'

/** What can be changed of a goal besides its place. */
export type GoalChange = Partial<Omit<Goal, 'at'>>

/** Goals that were never named are called this. */
const UNNAMED = new Set(['', 'goal'])

/** b = 1 / (s·w·a): how much of a way to this goal counts in the comprehensive weight. */
export function goalWeight({ area, strength, danger }: Goal): number {
  return 1 / (area * strength * danger)
}

/** Cells on which neither a goal nor the start may be put. */
export function takenCells({ start, goals }: ScenarioSpec): Cell[] {
  return [start, ...goals.map(({ at }) => at)]
}

export function isGoal(scenario: Scenario, at: Cell): boolean {
  return goalIndexAt(scenario, at) >= 0
}

/** -1 where there is no goal. */
export function goalIndexAt({ spec }: Scenario, [x, y]: Cell): number {
  return spec.goals.findIndex(({ at }) => at[0] === x && at[1] === y)
}

/** Moves a goal, or adds one when `index` is their number. Goals stay inside, apart from each other and from the start. */
export function placeGoal(scenario: Scenario, index: number, at: Cell): Scenario {
  const { spec } = scenario
  const [x, y] = at
  const inside = x >= 0 && y >= 0 && x < spec.width && y < spec.height
  const taken = takenCells(spec).some((cell) => cell[0] === x && cell[1] === y)
  if (!inside || taken || index < 0 || index > spec.goals.length) return scenario
  if (index === spec.goals.length) return withGoals(scenario, added(spec.goals, at))
  return withGoals(scenario, replaced(spec.goals, index, { at }))
}

export function changeGoal(scenario: Scenario, index: number, change: GoalChange): Scenario {
  const goal = scenario.spec.goals[index]
  if (!goal || sameFields(goal, { ...goal, ...change })) return scenario
  return withGoals(scenario, replaced(scenario.spec.goals, index, change))
}

/** The last goal stays: without one there is nothing to plan. */
export function removeGoal(scenario: Scenario, index: number): Scenario {
  const { goals } = scenario.spec
  if (goals.length < 2 || !goals[index]) return scenario
  return withGoals(
    scenario,
    goals.filter((_, i) => i !== index),
  )
}

/** A goal without a name of its own is told by its number. */
export function goalName({ goals }: ScenarioSpec, index: number): string {
  const name = goals[index]?.name.trim() ?? ''
  return name === '' ? String(index + 1) : name
}

/** Whether two specs ask the same of a planner: names are for people. */
export function askSame(a: ScenarioSpec, b: ScenarioSpec): boolean {
  return JSON.stringify(question(a)) === JSON.stringify(question(b))
}

/** The spec without its names, and without what moves once a robot drives: planners do not know it. */
export function question({ name, goals, drive, ...spec }: ScenarioSpec): object {
  return { ...spec, goals: goals.map(({ name: _, ...goal }) => goal) }
}

/** Letters for those that have no name yet: the first goal becomes A as soon as there is a B. */
function added(goals: Goal[], at: Cell): Goal[] {
  if (goals.length >= limits.max_goals) return goals
  const named = goals.map((goal, i) =>
    i === 0 && UNNAMED.has(goal.name) ? { ...goal, name: freeLetter(goals) } : goal,
  )
  return [...named, goalAt(at, freeLetter(named))]
}

function freeLetter(goals: Goal[]): string {
  const taken = new Set(goals.map(({ name }) => name))
  for (let i = 0; ; i++) {
    const round = i < 26 ? '' : String(Math.floor(i / 26) + 1)
    const letter = String.fromCharCode(65 + (i % 26)) + round
    if (!taken.has(letter)) return letter
  }
}

function replaced(goals: Goal[], index: number, change: Partial<Goal>): Goal[] {
  return goals.map((goal, i) => (i === index ? { ...goal, ...change } : goal))
}

function withGoals(scenario: Scenario, goals: Goal[]): Scenario {
  return goals === scenario.spec.goals
    ? scenario
    : { ...scenario, spec: { ...scenario.spec, goals } }
}

function sameFields(a: Goal, b: Goal): boolean {
  return (
    a.name === b.name && a.area === b.area && a.strength === b.strength && a.danger === b.danger
  )
}
