/** Sessions as links and as files. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { numbersOf } from '../model/cell_numbers'
import type { Session } from '../model/session'
import { scenarioBefore } from '../model/wall_changes'
import {
  blockedWithoutData,
  checkedFactors,
  type Generate,
  type Ground,
  packBits,
  packEdits,
  unpack,
} from './codec'
import { open, seal } from './envelope'
import { type Fields, fieldsOf, invalid, list, real, text } from './field_checks'
import { LinkError } from './link_error'
import { textBehind } from './link_in_text'
import { afterChanges } from './session_changes'
import { documentOf, readDocument, WEIGHTED } from './session_document'

export { LinkError } from './link_error'

export const PREFIX = '#x='
const BLOCKED = '@'
const FREE = '.'

const generate: Generate = async ({ generator, seed, density }, width, height) => {
  const made = await tools.generate(generator, width, height, seed, density)
  return { cells: made.cells, heights: numbersOf(made.heights), factors: null }
}

/** The text after `#x=`: the map as bits or as a generator call with edits, whichever is shorter. */
export async function encodeSession(session: Session): Promise<string> {
  const engine = await tools.version()
  const bits = await seal(packBits(session, engine))
  const edits = await packEdits(session, engine, generate)
  const short = edits && (await seal(edits))
  return short !== null && short.length < bits.length ? short : bits
}

/** Throws a LinkError. `hash`: `location.hash` or any text that contains a link. */
export async function decodeFragment(hash: string): Promise<Session> {
  const text = textBehind(PREFIX, hash, 'session')
  return unpack(await open(text), generate)
}

/** The session file (`.experiment.json`): readable JSON, the map drawn with `.` and `@`, heights or factors as rows of numbers, null where there is no data. */
export function sessionToFile(now: Session, engine: string): string {
  const session = { ...now, scenario: scenarioBefore(now) }
  const { cells, heights, factors, spec } = session.scenario
  const map = rowsOf(cells, spec.width, (row) =>
    Array.from(row, (cell) => (cell === 1 ? BLOCKED : FREE)).join(''),
  )
  const json = JSON.stringify({ ...documentOf(session, engine), map }, null, 2)
  const numbers = heights ?? factors
  if (numbers === null) return `${json}\n`
  // A row a line: indented as the rest, every number would stand on a line of its own.
  const rows = rowsOf(
    numbers,
    spec.width,
    (row) => `    ${JSON.stringify(Array.from(row, shortest))}`,
  )
  return `${json.slice(0, -2)},\n  "${heights ? 'heights' : 'factors'}": [\n${rows.join(',\n')}\n  ]\n}\n`
}

function rowsOf<T extends Uint8Array | Float32Array>(
  values: T,
  width: number,
  write: (row: T) => string,
): string[] {
  return Array.from({ length: values.length / width }, (_, y) =>
    write(values.subarray(y * width, (y + 1) * width) as T),
  )
}

/** The shortest number that is this one again when it is read. */
function shortest(number: number): number | null {
  if (Number.isNaN(number)) return null
  for (let digits = 6; digits < 9; digits++) {
    const rounded = Number(number.toPrecision(digits))
    if (Object.is(Math.fround(rounded), number)) return rounded
  }
  return number
}

/** Throws a LinkError. */
export async function sessionFromFile(content: string): Promise<Session> {
  const fields = fieldsOf(parse(content), 'document')
  const { spec, origin, ...rest } = readDocument(fields)
  const scenario = { spec, ...readGround(fields, spec), origin }
  return { ...rest, scenario: rest.changes ? afterChanges(scenario, rest.changes) : scenario }
}

function readGround(fields: Fields, { width, height, terrain }: ScenarioSpec): Ground {
  const cells = new Uint8Array(width * height)
  for (const [y, row] of readRows(fields.map, 'map', height).entries())
    cells.set(readRow(row, y, width), y * width)
  if (fields.factors !== undefined) {
    if (fields.format !== WEIGHTED) throw invalid('factors', `and ${WEIGHTED} must come together`)
    if (terrain) throw invalid('factors', 'cannot be used on a terrain')
    const factors = readNumbers(fields.factors, 'factors', width, height)
    return { cells, heights: null, factors: checkedFactors(factors) }
  }
  if (fields.heights === undefined && !terrain) return { cells, heights: null, factors: null }
  if (fields.heights === undefined) throw invalid('heights', 'are missing')
  if (!terrain) throw invalid('scenario.terrain', 'is missing, though there are heights')
  const heights = readNumbers(fields.heights, 'heights', width, height)
  return { cells: blockedWithoutData(cells, heights), heights, factors: null }
}

function readNumbers(
  value: unknown,
  what: 'heights' | 'factors',
  width: number,
  height: number,
): Float32Array {
  const numbers = new Float32Array(width * height)
  for (const [y, row] of readRows(value, what, height).entries())
    numbers.set(readNumberRow(row, what, y, width), y * width)
  return numbers
}

function readRows(value: unknown, field: string, height: number): unknown[] {
  const rows = list(value, field, height)
  if (rows.length !== height)
    throw invalid(field, `has ${rows.length} rows, but height is ${height}`)
  return rows
}

function readNumberRow(value: unknown, what: string, y: number, width: number): number[] {
  const field = `${what}[${y}]`
  const row = list(value, field, width)
  if (row.length !== width) throw invalid(field, `has ${row.length} ${what}, but width is ${width}`)
  return row.map((number, x) =>
    number === null ? Number.NaN : real(number, `${field}[${x}]`, -3e38, 3e38),
  )
}

function readRow(value: unknown, y: number, width: number): Uint8Array {
  const row = text(value, `map[${y}]`, width)
  if (row.length !== width)
    throw invalid(`map[${y}]`, `has ${row.length} cells, but width is ${width}`)
  const wrong = [...row].find((char) => char !== BLOCKED && char !== FREE)
  if (wrong !== undefined)
    throw invalid(`map[${y}]`, `contains "${wrong}"; only ${FREE} and ${BLOCKED} are allowed`)
  return Uint8Array.from(row, (char) => (char === BLOCKED ? 1 : 0))
}

function parse(content: string): unknown {
  try {
    return JSON.parse(content)
  } catch (error) {
    throw new LinkError(
      'link-damaged',
      `The file is not readable JSON: ${error instanceof Error ? error.message : error}`,
    )
  }
}
