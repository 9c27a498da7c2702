/** What a script gives, read to the end before anything on the page changes. What a reader would be asked about is an option by name. */
import type { Notice, ScenLine } from '@pkg/formicarium'
import { lateTools } from '../engine/late_tools'
import { tools } from '../engine/tools'
import { badOption, optionsOf, ScriptError, shortText, wholeNumber } from '../model/script_error'
import type { LoadOptions } from '../model/scripting'
import type { Scenario, Session } from '../model/session'
import type { TerrainPart } from '../model/tool_calls'
import type { ToldByLink } from '../share/comparison_link'
import { linkIn } from '../share/link_in_text'
import { bytesOf, refuseLarge } from './file_bytes'
import { fileName, stemOf } from './file_paths'
import { toScenario } from './imported'
import { LESSON_PREFIX } from './lesson'
import { type Carrier, canBeOpened, lookAt } from './looked_files'
import type { FoundFile, NamedBytes } from './offered_files'
import { ASKED, matricesOf, withEnds } from './open_files'
import { nameOfPicture, pictureOf, picturesNamed } from './ros_pictures'
import { scenario } from './store'

const OPTIONS = ['file', 'row', 'read', 'part', 'instance', 'leaveOut', 'usual'] as const

export type Content = { name: string; notices: Notice[] } & (
  | { kind: 'session'; session: Session }
  | { kind: 'comparison'; text: string; told?: ToldByLink }
  | { kind: 'results'; file: NamedBytes; instance: string | undefined; leaveOut: string[] }
  | { kind: 'order'; file: NamedBytes; tour: NamedBytes | null }
  | { kind: 'map'; scenario: Scenario }
  | { kind: 'ends'; scenario: Scenario }
)

/** Reads what a script gives. Throws where it cannot be read, leaves a choice, or an option has nothing to say about it. */
export async function contentOf(source: unknown, given: unknown): Promise<Content> {
  const options = new Options(optionsOf(given, OPTIONS, 'load') as LoadOptions)
  const content = await read(source, options)
  options.refuseUnused()
  return content
}

/** The options of a call, and which of them were of use. */
class Options {
  private readonly used = new Set<string>(['usual'])

  constructor(private readonly given: LoadOptions) {
    if (given.usual !== undefined && typeof given.usual !== 'boolean')
      throw badOption('usual', 'must be true or false')
  }

  take<K extends keyof LoadOptions>(key: K): LoadOptions[K] {
    this.used.add(key)
    return this.given[key]
  }

  get usual(): boolean {
    return this.given.usual === true
  }

  refuseUnused(): void {
    for (const [key, value] of Object.entries(this.given))
      if (value !== undefined && !this.used.has(key)) {
        const hint = 'Leave it out, or give a file that it is about.'
        throw new ScriptError('unused-option', key, `${key} says nothing about this`, hint)
      }
  }
}

async function read(source: unknown, options: Options): Promise<Content> {
  if (typeof source === 'string') return readText(source, options)
  if (source instanceof Blob) return readFiles([source], options)
  if (source instanceof FileList || Array.isArray(source)) return readFiles([...source], options)
  const { sessionFromObject } = await import('../share/session_object')
  const session = await sessionFromObject(source)
  return { kind: 'session', name: session.scenario.spec.name, notices: [], session }
}

async function readText(text: string, options: Options): Promise<Content> {
  refuseLarge(text.length, 'text')
  const link = linkIn(text)
  if (!link) return readTogether([{ name: 'text', bytes: new TextEncoder().encode(text) }], options)
  const none = { name: 'link', notices: [] }
  if (link.startsWith('#x')) {
    const { decodeFragment } = await import('../share/link')
    return { ...none, kind: 'session', session: await decodeFragment(link) }
  }
  if (link.startsWith(LESSON_PREFIX)) {
    const { lessonSession } = await import('./gallery_lessons')
    const session = await lessonSession(link.slice(LESSON_PREFIX.length))
    return { ...none, kind: 'session', session }
  }
  const { decodeFragment } = await import('../share/comparison_link')
  const { document, ...told } = await decodeFragment(link)
  return { ...none, kind: 'comparison', text: document, told }
}

async function readFiles(blobs: unknown[], options: Options): Promise<Content> {
  const given: NamedBytes[] = []
  for (const blob of blobs) {
    if (!(blob instanceof Blob)) throw badOption('source', 'must hold files alone')
    const file = blob instanceof File ? blob : new File([blob], 'file')
    given.push({ name: file.name, bytes: await bytesOf(file) })
  }
  return readTogether(given, options)
}

async function readTogether(given: NamedBytes[], options: Options): Promise<Content> {
  const { found, refused, nested, loose } = await lookAt(given)
  const [first] = [...refused, ...nested]
  if (first !== undefined) throw first
  const stranger = found.find((file) => !canBeOpened(file))
  // As a rule the import says why it is none of ours. In archives such files lie beside others.
  if (stranger && !(loose && found.some(canBeOpened)))
    return readMap({ ...stranger, kind: 'unknown' } as FoundFile, [], options)
  const known = found.filter(canBeOpened)
  const files = known.filter((file): file is FoundFile => file.kind !== 'carrier')
  const subject = await subjectOf(known, files, options)
  return readSubject(subject, files, options)
}

/** The one that is to be opened; the others belong to it. */
async function subjectOf(
  known: (FoundFile | Carrier)[],
  files: FoundFile[],
  options: Options,
): Promise<FoundFile | Carrier> {
  const named = await picturesNamed(files)
  const besides = (file: FoundFile | Carrier) =>
    file.kind === 'movingai-scen' || file.kind === 'tsplib-tour' || named.has(file as FoundFile)
  const own = known.filter((file) => !besides(file))
  const all = own.length > 0 ? own : known
  const names = all.map(({ name }) => name).join(', ')
  const wanted = options.take('file')
  if (wanted !== undefined) {
    const one = all.find(({ name }) => name === wanted || fileName(name) === wanted)
    if (one) return one
    const hint = `There are ${names || 'no files'}.`
    throw new ScriptError('no-such-file', 'file', `no file "${wanted}" can be opened here`, hint)
  }
  const [only, second] = all
  if (only && !second) return only
  if (only)
    throw needsChoice('file', `${all.length} files could be opened`, `{ file }, one of ${names}`)
  const hint = 'Give a link, a session, the text of a file, or files.'
  throw new ScriptError('nothing-to-open', 'source', 'there is nothing to open', hint)
}

async function readSubject(
  file: FoundFile | Carrier,
  together: FoundFile[],
  options: Options,
): Promise<Content> {
  const plain = { name: fileName(file.name), notices: [] }
  const text = () => new TextDecoder().decode(file.bytes)
  switch (file.kind) {
    case 'carrier':
      return readText(file.text, options)
    case 'session': {
      const { sessionFromFile } = await import('../share/link')
      return { ...plain, kind: 'session', session: await sessionFromFile(text()) }
    }
    case 'comparison':
      return { ...plain, kind: 'comparison', text: text() }
    case 'results':
      return { ...plain, kind: 'results', file, ...placeOf(options) }
    case 'tsplib':
      return { ...plain, kind: 'order', file, tour: tourFor(file, together) }
    case 'movingai-scen':
      return readEnds(file, options)
    default:
      return readMap(file, together, options)
  }
}

/** On which map results were made, and which maps of theirs are left out. */
function placeOf(options: Options): { instance: string | undefined; leaveOut: string[] } {
  const instance = options.take('instance')
  const leaveOut = options.take('leaveOut') ?? []
  if (instance !== undefined) shortText(instance, 'instance', 200)
  if (!Array.isArray(leaveOut)) throw badOption('leaveOut', 'must be a list of names')
  for (const [at, name] of leaveOut.entries()) shortText(name, `leaveOut[${at}]`, 200)
  return { instance, leaveOut }
}

function tourFor(file: NamedBytes, together: FoundFile[]): NamedBytes | null {
  const tours = together.filter(({ kind }) => kind === 'tsplib-tour')
  const alike = tours.find(({ name }) => stemOf(name) === stemOf(file.name))
  if (alike || tours.length < 2) return alike ?? tours[0] ?? null
  const names = tours.map(({ name }) => name).join(', ')
  throw needsChoice('source', `${tours.length} tours came with it`, `one of ${names} alone`)
}

async function readMap(file: FoundFile, together: FoundFile[], options: Options): Promise<Content> {
  const name = fileName(file.name)
  const imported = file.raster
    ? await lateTools.importTerrain(file.bytes, name, partOf(options))
    : await readFlat(file, together, options)
  const scens = together.filter(({ kind }) => kind === 'movingai-scen')
  const map = toScenario(imported, name)
  const [scen, other] = scens
  if (other) throw needsChoice('source', 'several .scen files came with the map', 'one of them')
  const asked = scen ? withEnds(map, await rowOf(scen, map, options)) : map
  return { kind: 'map', name, notices: imported.warnings, scenario: asked }
}

async function readFlat(file: FoundFile, together: FoundFile[], options: Options) {
  const needs = file.kind === 'ros-map' ? await nameOfPicture(file) : ''
  const image = needs === '' ? undefined : pictureOf(file, needs, together)
  const matrices = file.kind === 'matrix' ? await matricesOf(file) : []
  const isOpen = ASKED.has(file.kind) || !file.certain || matrices.length > 1
  const read = options.take('read')
  if (isOpen && read === undefined && !options.usual && file.kind !== 'unknown')
    throw needsChoice(
      'read',
      `${fileName(file.name)} ${whyOpen(file, matrices.length)}`,
      ways(file),
    )
  const usual = matrices.length > 1 ? { matrix: 1 } : {}
  return tools.importMap(file.bytes, fileName(file.name), read ?? usual, image?.bytes)
}

const whyOpen = ({ kind, why }: FoundFile, matrices: number) =>
  matrices > 1
    ? `holds ${matrices} matrices`
    : ASKED.has(kind)
      ? `is a ${kind}, which can be read in several ways`
      : `may not be a ${kind}: ${why}`

function ways({ kind }: FoundFile): string {
  if (kind === 'picture') return '{ read: { picture: { … } } }'
  if (kind === 'matrix') return '{ read: { matrix: 1 } }'
  return ASKED.has(kind) ? "{ read: { unknown: 'blocked' } }" : '{ read: {} }'
}

function partOf(options: Options): TerrainPart {
  const part = options.take('part')
  if (part !== undefined) return part
  if (options.usual) return {}
  throw needsChoice(
    'part',
    'a raster of heights may be opened in part',
    '{ part: {} } for all of it',
  )
}

/** Start and goal for the map on show. */
async function readEnds(file: FoundFile, options: Options): Promise<Content> {
  const now = scenario.peek()
  if (!now) throw new ScriptError('no-map', 'source', 'no map is on show', 'Open its map first.')
  const asked = withEnds(now, await rowOf(file, now, options))
  return { kind: 'ends', name: fileName(file.name), notices: [], scenario: asked }
}

async function rowOf(file: NamedBytes, { spec }: Scenario, options: Options): Promise<ScenLine> {
  const { lines } = await tools.importScen(file.bytes)
  const { width, height } = spec
  const fitting = lines.filter((line) => line.width === width && line.height === height)
  const [first] = fitting
  const name = fileName(file.name)
  if (!first) {
    const hint = `Open the map ${lines[0]?.map ?? ''} first, or together with it.`
    throw new ScriptError('scen-needs-map', 'row', `no row of ${name} fits this map`, hint)
  }
  const row = options.take('row')
  if (row === undefined && (options.usual || fitting.length === 1)) return first
  const rows = `${first.line} to ${fitting.at(-1)?.line}`
  if (row === undefined)
    throw needsChoice('row', `${name} has ${fitting.length} rows`, `{ row }, from ${rows}`)
  const number = wholeNumber(row, 'row', 1, Number.MAX_SAFE_INTEGER)
  const line = fitting.find((one) => one.line === number)
  if (line) return line
  throw new ScriptError('bad-option', 'row', `${name} has no row ${row}`, `Rows are ${rows}.`)
}

/** What a reader would be asked. */
function needsChoice(field: string, what: string, how: string): ScriptError {
  const hint = `Pass ${how}${field === 'source' ? '.' : ', or { usual: true } for what the page proposes.'}`
  return new ScriptError('choice-needed', field, what, hint)
}
