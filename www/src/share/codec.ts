/**
 * A session as bytes, and back:
 *
 *     u32 checksum · u8 container version · varint n · n bytes of JSON (session_document.ts) · the map · on a terrain its heights
 *                    · on weighted ground its factors
 *
 * The checksum (FNV-1a, lowest byte first) covers all that follows and stands first in every version: a damaged link must never
 * pass for a newer one, or for another map.
 *
 * The map is 1 bit per cell, row by row from the upper left, most significant bit first; or, when the JSON's `map` says
 * `edits`, the cells to toggle after the generator call in `scenario.origin`: varint count, then varint gaps. Such a terrain has its
 * heights from the generator, any other brings its own (heights.ts). Factors are packed as heights are.
 *
 * Planes are written as version 1. A terrain is version 2, weighted ground version 3, so that a page that does not know them says so
 * instead of showing a plane.
 */
import { limits } from '../model/facts'
import type { MapCells, Origin, Session } from '../model/session'
import { scenarioBefore } from '../model/wall_changes'
import { MOST_FACTOR, PLAIN, plainOrNone } from '../model/weights'
import { bitsOf, joined, Reader, readBits, varint } from './byte_stream'
import { packNumbers, unpackNumbers } from './cell_numbers'
import { fieldsOf, invalid, oneOf } from './field_checks'
import { changed, damaged, LinkError } from './link_error'
import { afterChanges } from './session_changes'
import {
  type Described,
  documentOf,
  readDocument,
  WEIGHTED as WEIGHTED_DOCUMENT,
} from './session_document'

/** What a map consists of, whoever made it. */
export type Ground = MapCells

/** The engine's generators, as far as the codec needs them. */
export type Generate = (origin: Origin, width: number, height: number) => Promise<Ground>

const PLANE = 1
const TERRAIN = 2
const WEIGHTED = 3
const CHECKSUM_BYTES = 4
const MAX_CELLS = limits.max_side ** 2
/** A link carries as many heights or factors as this, about 1000 × 1000; a file carries all. */
const MAX_NUMBERS = 1 << 20
/** No honest container is larger: a full map of bits, four bytes a height, and a generous document. */
export const MAX_BYTES = MAX_CELLS / 8 + 4 * MAX_NUMBERS + (1 << 18)

/** The session with its map as bits: the one before all changes. */
export function packBits(now: Session, engine: string): Uint8Array<ArrayBuffer> {
  const session = { ...now, scenario: scenarioBefore(now) }
  const { cells, heights, factors } = session.scenario
  const numbers = heights ?? factors
  if (numbers) checkNumbers(numbers.length, heights ? 'heights' : 'factors')
  const tail = [bitsOf(cells), ...(numbers ? [packNumbers(numbers)] : [])]
  return container(session, engine, 'bits', tail)
}

/** The session with its map as a generator call and edits; null when no generator made the map. */
export async function packEdits(
  now: Session,
  engine: string,
  generate: Generate,
): Promise<Uint8Array<ArrayBuffer> | null> {
  const session = { ...now, scenario: scenarioBefore(now) }
  const { origin, spec, cells, heights, factors } = session.scenario
  // No generator makes factors.
  if (origin === null || factors) return null
  const generated = await generate(origin, spec.width, spec.height)
  if (!sameHeights(generated.heights, heights)) return null
  const edits: number[] = []
  for (let i = 0; i < cells.length; i++) if (cells[i] !== generated.cells[i]) edits.push(i)
  // From here on bits are shorter, whatever the gaps.
  if (edits.length > cells.length / 8) return null
  return container(session, engine, 'edits', [editBytes(edits)])
}

export async function unpack(bytes: Uint8Array, generate: Generate): Promise<Session> {
  const reader = new Reader(verifiedBytes(bytes))
  const version = reader.byte()
  if (version > WEIGHTED)
    throw new LinkError(
      'link-newer',
      `The link's container has version ${version}; this page reads ${WEIGHTED}.`,
    )
  if (version < PLANE) throw damaged('its first byte is no container version')
  const json = parse(reader.take(reader.varint()))
  const described = readDocument(json)
  const { spec, origin, ...rest } = described
  const { changes } = rest
  if ((spec.terrain !== undefined) !== (version === TERRAIN))
    throw invalid('scenario.terrain', 'and heights must come together')
  if (version === WEIGHTED && fieldsOf(json, 'document').format !== WEIGHTED_DOCUMENT)
    throw invalid('factors', `and ${WEIGHTED_DOCUMENT} must come together`)
  const map = oneOf(fieldsOf(json, 'document').map, 'map', ['bits', 'edits'] as const)
  const ground =
    map === 'bits'
      ? readOwn(reader, described, version === WEIGHTED)
      : readEdits(reader, described, generate)
  const scenario = { spec, ...(await ground), origin }
  if (reader.left > 0) throw damaged('it goes on behind its end')
  return { ...rest, scenario: changes ? afterChanges(scenario, changes) : scenario }
}

function container(
  session: Session,
  engine: string,
  map: 'bits' | 'edits',
  tail: Uint8Array[],
): Uint8Array<ArrayBuffer> {
  const document = documentOf(session, engine)
  const json = new TextEncoder().encode(JSON.stringify({ ...document, map }))
  const { heights, factors } = session.scenario
  const version = heights ? TERRAIN : factors ? WEIGHTED : PLANE
  return withChecksum([[version, ...varint(json.length)], json, ...tail])
}

/** The parts one after the other, their checksum before them. */
export function withChecksum(parts: ArrayLike<number>[]): Uint8Array<ArrayBuffer> {
  const bytes = joined([new Uint8Array(CHECKSUM_BYTES), ...parts])
  new DataView(bytes.buffer).setUint32(0, checksum(bytes.subarray(CHECKSUM_BYTES)), true)
  return bytes
}

/** What the checksum covers, if it agrees. */
export function verifiedBytes(bytes: Uint8Array): Uint8Array {
  if (bytes.length < CHECKSUM_BYTES) throw damaged('it ends too early')
  const noted = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true)
  const covered = bytes.subarray(CHECKSUM_BYTES)
  if (checksum(covered) !== noted) throw changed()
  return covered
}

/** FNV-1a, 32 bits: enough against slips and cuts, and no claim of more. */
function checksum(bytes: Uint8Array): number {
  let hash = 0x811c9dc5
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193)
  return hash >>> 0
}

async function readOwn(reader: Reader, { spec }: Described, isWeighted: boolean): Promise<Ground> {
  const count = spec.width * spec.height
  const cells = readBits(reader, count)
  if (isWeighted) {
    checkNumbers(count, 'factors')
    return { cells, heights: null, factors: checkedFactors(unpackNumbers(reader, count)) }
  }
  if (!spec.terrain) return { cells, heights: null, factors: null }
  checkNumbers(count, 'heights')
  const heights = unpackNumbers(reader, count)
  return { cells: blockedWithoutData(cells, heights), heights, factors: null }
}

function checkNumbers(count: number, what: 'heights' | 'factors'): void {
  if (count <= MAX_NUMBERS) return
  const message = `A link carries up to ${MAX_NUMBERS} ${what}; this map has ${count}.`
  throw new LinkError('link-too-large', message, what)
}

/** Factors as the engine takes them; null where all ground is plain. */
export function checkedFactors(factors: Float32Array): Float32Array | null {
  const wrong = factors.find((factor) => !(factor >= PLAIN && factor <= MOST_FACTOR))
  if (wrong !== undefined)
    throw invalid('factors', `must be ${PLAIN} to ${MOST_FACTOR}; one is ${wrong}`)
  return plainOrNone(factors)
}

/** Nothing can be where the height is not known. */
export function blockedWithoutData(cells: Uint8Array, heights: Float32Array): Uint8Array {
  return cells.map((cell, i) => (Number.isFinite(heights[i]) ? cell : 1))
}

function editBytes(edits: number[]): Uint8Array {
  const gaps = edits.map((cell, i) => cell - (i === 0 ? 0 : (edits[i - 1] ?? 0)))
  return Uint8Array.from([...varint(edits.length), ...gaps.flatMap(varint)])
}

async function readEdits(
  reader: Reader,
  { spec, origin }: Described,
  generate: Generate,
): Promise<Ground> {
  if (origin === null) throw damaged('it has edits of a map but not the map they belong to')
  const generated = await generate(origin, spec.width, spec.height)
  if ((generated.heights === null) !== (spec.terrain === undefined))
    throw invalid('scenario.origin.generator', 'makes another kind of map')
  const cells = generated.cells.slice()
  let at = 0
  for (let left = reader.varint(); left > 0; left--) {
    at += reader.varint()
    if (at >= cells.length) throw damaged('an edit lies outside the map')
    cells[at] = cells[at] === 1 ? 0 : 1
  }
  return { cells, heights: generated.heights, factors: null }
}

function sameHeights(a: Float32Array | null, b: Float32Array | null): boolean {
  if (a === null || b === null) return a === b
  return a.length === b.length && a.every((height, i) => Object.is(height, b[i]))
}

function parse(json: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(json))
  } catch {
    throw damaged('its description cannot be read')
  }
}
