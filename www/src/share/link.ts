/** Sessions as links and as experiment files. */
import { tools } from '../engine/tools'
import type { Session } from '../session'
import { fieldsOf, invalid, list, text } from './check'
import { type Generate, packBits, packEdits, unpack } from './codec'
import { open, seal } from './envelope'
import { LinkError } from './error'
import { documentOf, readDocument } from './experiment'

export { LinkError } from './error'

/** Longer links are cut by some hosts and mail programs: offer a file instead. Characters of the fragment's payload. */
export const LINK_LIMIT = 8000

const PREFIX = '#x='
const BLOCKED = '@'
const FREE = '.'

const generate: Generate = async ({ generator, seed, density }, width, height) =>
  (await tools.generate(generator, width, height, seed, density)).cells

/** The text after `#x=`: the map as bits or as a generator call with edits, whichever is shorter. */
export async function encodeSession(session: Session): Promise<string> {
  const engine = await tools.version()
  const bits = await seal(packBits(session, engine))
  const edits = await packEdits(session, engine, generate)
  const short = edits && (await seal(edits))
  return short !== null && short.length < bits.length ? short : bits
}

/** Throws a LinkError. `hash`: `location.hash` or any address that ends with it. */
export async function decodeFragment(hash: string): Promise<Session> {
  const at = hash.indexOf(PREFIX)
  if (at < 0) throw new LinkError('link-foreign', 'This link carries no experiment.')
  return unpack(await open(hash.slice(at + PREFIX.length)), generate)
}

/** The experiment file: readable JSON, the map drawn with `.` and `@`. */
export function sessionToFile(session: Session, engine: string): string {
  const { cells, spec } = session.scenario
  const rows = Array.from({ length: spec.height }, (_, y) =>
    Array.from(cells.subarray(y * spec.width, (y + 1) * spec.width), (cell) =>
      cell === 1 ? BLOCKED : FREE,
    ).join(''),
  )
  return `${JSON.stringify({ ...documentOf(session, engine), map: rows }, null, 2)}\n`
}

/** Throws a LinkError. */
export async function sessionFromFile(content: string): Promise<Session> {
  const fields = fieldsOf(parse(content), 'document')
  const { spec, origin, ...rest } = readDocument(fields)
  const rows = list(fields.map, 'map', spec.height)
  if (rows.length !== spec.height)
    throw invalid('map', `has ${rows.length} rows, but height is ${spec.height}`)
  const cells = new Uint8Array(spec.width * spec.height)
  for (const [y, row] of rows.entries()) cells.set(readRow(row, y, spec.width), y * spec.width)
  return { ...rest, scenario: { spec, cells, origin } }
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
