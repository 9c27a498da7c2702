/** Reads what is typed into the table of goals. Refusals are worded as the engine's own. */
import type { EngineError, Goal, ScenarioSpec } from '@pkg/formicarium'
import type { Cell } from '../model/cell'
import { cellOfPlace } from '../model/cell_of_place'
import { goalWeight } from '../model/goals'
import { scaleOf } from '../model/world'

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

const CELL = /^\(?\s*(\d+)\s*[,;\s]\s*(\d+)\s*\)?$/
const NUMBER = '([-−+]?(?:\\d+\\.?\\d*|\\.\\d+))'
const METRES = new RegExp(`^\\(?\\s*${NUMBER}\\s*[m米]\\s*[,;\\s]\\s*${NUMBER}\\s*[m米]\\s*\\)?$`)

/** "11, 4" and the like, or "-1.5m, 2m" on a map that has a scale, as the command line takes it; null for anything else. */
export function readPlace(spec: ScenarioSpec, text: string): Cell | null {
  const [, column, row] = CELL.exec(text) ?? []
  if (column !== undefined && row !== undefined) return [Number(column), Number(row)]
  const [, x, y] = METRES.exec(text) ?? []
  if (x === undefined || y === undefined || scaleOf(spec) === null) return null
  return cellOfPlace(spec, [metres(x), metres(y)])
}

/** As it is copied from the page, with a minus sign of its own. */
const metres = (text: string) => Number(text.replace('−', '-'))

/** What is wrong with a place for the start, or for the goal with this index; null for one that can be used. */
export function placeError(
  spec: ScenarioSpec,
  end: number | 'start',
  text: string,
): EngineError | null {
  const at = readPlace(spec, text)
  const role = end === 'start' ? 'start' : 'goal'
  if (at === null) {
    const inMetres = scaleOf(spec) !== null
    const hint = `write column and row, as in 11, 4${inMetres ? ', or metres, as in 2m, 0.5m' : ''}`
    const kind = inMetres ? 'place-in-metres' : 'place'
    return refusal(kind, role, `“${text}” is no place`, hint, { value: text })
  }
  const [x, y] = at
  const { width, height } = spec
  const args = { x: String(x), y: String(y) }
  if (x < 0 || y < 0 || x >= width || y >= height) {
    const message = `the ${role} (${x}, ${y}) lies outside the map of ${width} × ${height} cells`
    const hint = `columns run from 0 to ${width - 1}, rows from 0 to ${height - 1}`
    return refusal('outside-map', role, message, hint, args)
  }
  return takenError(spec, end, at, args)
}

function takenError(
  spec: ScenarioSpec,
  end: number | 'start',
  [x, y]: Cell,
  args: Record<string, string>,
): EngineError | null {
  const elsewhere = 'choose another cell'
  const isHere = ([column, row]: Cell) => column === x && row === y
  if (spec.goals.some(({ at }, i) => i !== end && isHere(at)))
    return end === 'start'
      ? refusal('start-on-goal', 'start', `a goal lies on (${x}, ${y})`, elsewhere, args)
      : refusal(
          'goal-twice',
          'goals',
          `two goals lie on the cell (${x}, ${y})`,
          'move one of them, or remove it',
          args,
        )
  if (end !== 'start' && isHere(spec.start))
    return refusal('goal-on-start', 'goal', `the start lies on (${x}, ${y})`, elsewhere, args)
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
