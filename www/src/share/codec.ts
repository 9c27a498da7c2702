/**
 * A session as bytes, and back:
 *
 *     u32 checksum · u8 container version (1) · varint n · n bytes of JSON (experiment.ts) · the map
 *
 * The checksum (FNV-1a, lowest byte first) covers all that follows and stands first in every version: a damaged link must never
 * pass for a newer one, or for another map.
 *
 * The map is 1 bit per cell, row by row from the upper left, most significant bit first; or, when the JSON's `map` says
 * `edits`, the cells to toggle after the generator call in `scenario.origin`: varint count, then varint gaps.
 */
import type { Origin, Session } from '../session'
import { fieldsOf, oneOf } from './check'
import { LinkError } from './error'
import { type Described, documentOf, readDocument } from './experiment'

/** The engine's generators, as far as the codec needs them. */
export type Generate = (origin: Origin, width: number, height: number) => Promise<Uint8Array>

const VERSION = 1
const CHECKSUM_BYTES = 4
/** No honest container is larger: a full map of bits, or as many bytes of edits, and a generous document. */
export const MAX_BYTES = (4096 * 4096) / 8 + (1 << 18)

/** The session with its map as bits. */
export function packBits(session: Session, engine: string): Uint8Array<ArrayBuffer> {
  return container(documentOf(session, engine), 'bits', bitsOf(session.scenario.cells))
}

/** The session with its map as a generator call and edits; null when no generator made the map. */
export async function packEdits(
  session: Session,
  engine: string,
  generate: Generate,
): Promise<Uint8Array<ArrayBuffer> | null> {
  const { origin, spec, cells } = session.scenario
  if (origin === null) return null
  const generated = await generate(origin, spec.width, spec.height)
  const edits: number[] = []
  for (let i = 0; i < cells.length; i++) if (cells[i] !== generated[i]) edits.push(i)
  // From here on bits are shorter, whatever the gaps.
  if (edits.length > cells.length / 8) return null
  return container(documentOf(session, engine), 'edits', editBytes(edits))
}

export async function unpack(bytes: Uint8Array, generate: Generate): Promise<Session> {
  const reader = new Reader(intact(bytes))
  const version = reader.byte()
  if (version > VERSION)
    throw new LinkError(
      'link-newer',
      `The link's container has version ${version}; this page reads ${VERSION}.`,
    )
  if (version < VERSION) throw damaged('its first byte is no container version')
  const json = parse(reader.take(reader.varint()))
  const described = readDocument(json)
  const map = oneOf(fieldsOf(json, 'document').map, 'map', ['bits', 'edits'] as const)
  const cells =
    map === 'bits' ? readBits(reader, described) : await readEdits(reader, described, generate)
  const { spec, origin, ...rest } = described
  return { ...rest, scenario: { spec, cells, origin } }
}

function container(
  document: object,
  map: 'bits' | 'edits',
  tail: Uint8Array,
): Uint8Array<ArrayBuffer> {
  const json = new TextEncoder().encode(JSON.stringify({ ...document, map }))
  return withChecksum([[VERSION, ...varint(json.length)], json, tail])
}

/** The parts one after the other, their checksum before them. */
export function withChecksum(parts: ArrayLike<number>[]): Uint8Array<ArrayBuffer> {
  const length = parts.reduce((sum, part) => sum + part.length, CHECKSUM_BYTES)
  const bytes = new Uint8Array(length)
  let at = CHECKSUM_BYTES
  for (const part of parts) {
    bytes.set(part, at)
    at += part.length
  }
  new DataView(bytes.buffer).setUint32(0, checksum(bytes.subarray(CHECKSUM_BYTES)), true)
  return bytes
}

/** What the checksum covers, if it agrees. */
function intact(bytes: Uint8Array): Uint8Array {
  if (bytes.length < CHECKSUM_BYTES) throw damaged('it ends too early')
  const noted = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true)
  const covered = bytes.subarray(CHECKSUM_BYTES)
  if (checksum(covered) !== noted) throw damaged('it is not the same as when it was made')
  return covered
}

/** FNV-1a, 32 bits: enough against slips and cuts, and no claim of more. */
function checksum(bytes: Uint8Array): number {
  let hash = 0x811c9dc5
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193)
  return hash >>> 0
}

export function bitsOf(cells: Uint8Array): Uint8Array {
  const bits = new Uint8Array(Math.ceil(cells.length / 8))
  for (let i = 0; i < cells.length; i++) {
    if (cells[i] === 1) bits[i >> 3] = (bits[i >> 3] ?? 0) | (128 >> (i & 7))
  }
  return bits
}

function readBits(reader: Reader, { spec }: Described): Uint8Array {
  const count = spec.width * spec.height
  const bits = reader.take(Math.ceil(count / 8))
  return Uint8Array.from({ length: count }, (_, i) => ((bits[i >> 3] ?? 0) >> (7 - (i & 7))) & 1)
}

function editBytes(edits: number[]): Uint8Array {
  const gaps = edits.map((cell, i) => cell - (i === 0 ? 0 : (edits[i - 1] ?? 0)))
  return Uint8Array.from([...varint(edits.length), ...gaps.flatMap(varint)])
}

async function readEdits(
  reader: Reader,
  { spec, origin }: Described,
  generate: Generate,
): Promise<Uint8Array> {
  if (origin === null) throw damaged('it has edits of a map but not the map they belong to')
  const cells = (await generate(origin, spec.width, spec.height)).slice()
  let at = 0
  for (let left = reader.varint(); left > 0; left--) {
    at += reader.varint()
    if (at >= cells.length) throw damaged('an edit lies outside the map')
    cells[at] = cells[at] === 1 ? 0 : 1
  }
  return cells
}

/** Seven bits a byte, lowest first; the high bit says that more follow. */
function varint(value: number): number[] {
  return value < 128 ? [value] : [(value & 127) | 128, ...varint(value >>> 7)]
}

class Reader {
  private at = 0

  constructor(private readonly bytes: Uint8Array) {}

  byte(): number {
    const byte = this.bytes[this.at++]
    if (byte === undefined) throw damaged('it ends too early')
    return byte
  }

  varint(): number {
    let value = 0
    for (let shift = 0; shift < 28; shift += 7) {
      const byte = this.byte()
      value |= (byte & 127) << shift
      if (byte < 128) return value
    }
    throw damaged('a number in it is too long')
  }

  take(count: number): Uint8Array {
    if (this.at + count > this.bytes.length) throw damaged('it ends too early')
    this.at += count
    return this.bytes.subarray(this.at - count, this.at)
  }
}

function parse(json: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(json))
  } catch {
    throw damaged('its description cannot be read')
  }
}

export function damaged(why: string): LinkError {
  return new LinkError('link-damaged', `The link is damaged: ${why}.`)
}
