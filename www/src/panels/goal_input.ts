/** Reads what is typed into the table of goals. Refusals have the engine's kinds, so that they read as the engine's own. */
import type { EngineError, Goal, ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from '../model/cell'
import { goalWeight } from '../model/goals'

type Quantity = 'area' | 'strength' | 'danger'

/** As large as a link may hold. */
const MOST = 1e6

export function quantityError(goal: Goal, key: Quantity, text: string): EngineError | null {
  const value = text === '' ? Number.NaN : Number(text)
  const weight = goalWeight({ ...goal, [key]: value })
  if (value > 0 && value <= MOST && weight > 0 && Number.isFinite(weight)) return null
  return refusal('quantity', key, `${key} = ${text} cannot be used`, 'give a positive number', {
    value: text,
  })
}

/** "11, 4" and the like; null for anything else. */
export function readPlace(text: string): Cell | null {
  const [, x, y] = /^\(?\s*(\d+)\s*[,;\s]\s*(\d+)\s*\)?$/.exec(text) ?? []
  return x === undefined || y === undefined ? null : [Number(x), Number(y)]
}

export function placeError(spec: ScenarioSpec, index: number, text: string): EngineError | null {
  const at = readPlace(text)
  if (at === null)
    return refusal('place', 'goal', `“${text}” is no place`, 'write column and row, as in 11, 4', {
      value: text,
    })
  const [x, y] = at
  const { width, height } = spec
  const args = { x: String(x), y: String(y) }
  if (x >= width || y >= height) {
    const message = `the goal (${x}, ${y}) lies outside the map of ${width} × ${height} cells`
    const hint = `columns run from 0 to ${width - 1}, rows from 0 to ${height - 1}`
    return refusal('outside-map', 'goal', message, hint, args)
  }
  const taken = spec.goals.some((goal, i) => i !== index && goal.at[0] === x && goal.at[1] === y)
  if (taken)
    return refusal(
      'goal-twice',
      'goals',
      `two goals lie on the cell (${x}, ${y})`,
      'move one of them, or remove it',
      args,
    )
  if (spec.start[0] === x && spec.start[1] === y)
    return refusal(
      'goal-on-start',
      'goal',
      `the start lies on (${x}, ${y})`,
      'choose another cell',
      args,
    )
  return null
}

function refusal(
  kind: string,
  field: string,
  message: string,
  hint: string,
  args: Record<string, string>,
): EngineError {
  return { kind, field, message, hint, args }
}
