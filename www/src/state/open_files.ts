/** Files in: recognises what came together, and puts it where it belongs. */
import type { EngineError, Imported, ReadOptions, ScenLine } from '@pkg/formicarium'
import { effect } from '@preact/signals'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import { goalAt, type Session } from '../model/session'
import { liftEnds } from '../model/terrain'
import type { TerrainPart } from '../model/tool_calls'
import { loadSession, notify, scenario, setScenario, showView } from '.'
import { bytesOf, MAX_BYTES, refuseLarge } from './file_bytes'
import type { Opening } from './files'
import { filesWithin } from './folder_files'
import { toScenario } from './imported'
import { lazyParts } from './lazy_parts'
import {
  type FoundFile,
  type MapChoice,
  type MapFile,
  mapChoice,
  mapFile,
  type NamedBytes,
  scenChoice,
  type Taker,
  type TerrainFile,
  terrainFile,
} from './offered_files'
import { offerOrder } from './order_play'
import { autoplay } from './sessions'
import { suitSpeed } from './speed'
import { importPart, offerTerrain } from './terrain_files'

/** Archives within archives; deeper ones are no archives that anybody packs. */
const MAX_DEPTH = 3
/** All files of a folder together. */
const MAX_TOTAL = 8 * MAX_BYTES

const sessionFormat = () => import('../share/link')

/** Kinds that leave a choice. */
const ASKED = new Set(['picture', 'ros-map', 'occupancy-grid'])

/** Pasted or typed text: a share link, or the contents of any file we read. */
export async function openText(text: string, opening: Opening = {}): Promise<void> {
  refuseLarge(text.length, t('maps.pastedName'))
  // A file may contain a link, so only text that is no JSON is searched for one.
  const fragment = text.trimStart().startsWith('{') ? null : /#[xq]=[\w-]+/.exec(text)?.[0]
  if (fragment?.startsWith('#q')) {
    const { decodeFragment } = await import('../share/comparison_link')
    await openComparisonText(await decodeFragment(fragment))
  } else if (fragment) replay(await (await sessionFormat()).decodeFragment(fragment))
  else
    await openTogether(
      [{ name: t('maps.pastedName'), bytes: new TextEncoder().encode(text) }],
      opening,
    )
}

export async function openFiles(files: File[]): Promise<void> {
  await openTogether(await contentsOf(files))
}

/** Opens files as maps alone, each of them, and hands them to `take` instead of the race. */
export async function openMapsFor(files: File[], take: Taker): Promise<void> {
  const looked: Looked = { found: [], refused: [], loose: false }
  for (const file of await contentsOf(files)) await look(file, looked, 0)
  const found = looked.found.filter((file): file is FoundFile => file.kind !== 'carrier')
  const named = await picturesNamed(found)
  const maps = found.filter((file) => (file.map || file.kind === 'unknown') && !named.has(file))
  for (const file of maps) {
    await openOne(file, found, { take })
    await answered()
  }
  if (looked.refused.length > 0) throw looked.refused[0]
  if (maps.length === 0) throw nothingWithin(files[0]?.name ?? '')
}

async function contentsOf(files: File[]): Promise<NamedBytes[]> {
  const given: NamedBytes[] = []
  for (const file of files) given.push({ name: file.name, bytes: await bytesOf(file) })
  return given
}

/** Once no file waits for the reader to say how it is meant. */
function answered(): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (mapFile.value || terrainFile.value) return
      resolve()
      queueMicrotask(() => stop())
    })
  })
}

/** Dropped files and folders, with what lies in them. */
export async function openEntries(entries: FileSystemEntry[]): Promise<void> {
  const files = await filesWithin(entries)
  const given: NamedBytes[] = []
  let total = 0
  for (const { path, file } of files) {
    total += file.size
    if (total > MAX_TOTAL) break
    if (file.size <= MAX_BYTES) given.push({ name: path, bytes: await bytesOf(file) })
  }
  await openTogether(given, { loose: true })
}

interface Together extends Opening {
  /** Where a map goes instead of the race. */
  take?: Taker
  /** They lay in a folder or archive: what cannot be opened is passed over. */
  loose?: boolean
}

/** A picture of ours, by the session or comparison in it. */
interface Carrier extends NamedBytes {
  kind: 'carrier'
  text: string
}

interface Looked {
  found: (FoundFile | Carrier)[]
  refused: unknown[]
  loose: boolean
}

/** Opens files that came together. Refusals are thrown, and leave the page as it was. */
async function openTogether(given: NamedBytes[], opening: Together = {}): Promise<void> {
  const looked: Looked = { found: [], refused: [], loose: opening.loose ?? false }
  for (const file of withWaiting(given)) await look(file, looked, 0)
  const { found, refused, loose } = looked
  const known = found.filter(canBeOpened)
  const opened = await openFound(loose || known.length > 0 ? known : found, opening)
  if (!loose && opened && known.length > 0) tellLeftOut(found.filter((file) => !canBeOpened(file)))
  if (refused.length > 0 && !(loose && opened)) throw refused[0]
  if (!opened) throw nothingWithin(given[0]?.name ?? '')
}

/** Of files that were named one by one, the reader hears which are none of ours. */
function tellLeftOut(
  files: NamedBytes[],
  why: 'opening.leftOut' | 'opening.oneOrder' = 'opening.leftOut',
): void {
  const names = files.map(({ name }) => fileName(name)).join(', ')
  if (names !== '') notify('warning', t(why, { names }))
}

function nothingWithin(name: string): EngineError {
  const message = t('opening.nothingToOpen', { name })
  return {
    kind: 'nothing-to-open',
    field: name,
    message,
    hint: t('opening.nothingToOpenHint'),
    args: {},
  }
}

/** A ROS map that waits for its picture goes on with what came now, if that is it. */
function withWaiting(given: NamedBytes[]): NamedBytes[] {
  const waiting = mapFile.peek()
  const needs = waiting?.needs
  if (!waiting || !needs || !given.some(({ name }) => sameName(name, needs))) return given
  mapFile.value = null
  return [waiting, ...given]
}

async function look(file: NamedBytes, looked: Looked, depth: number): Promise<void> {
  try {
    const { name, bytes } = file
    const text = await carriedBy(bytes)
    if (text !== null) looked.found.push({ name, bytes, kind: 'carrier', text })
    else {
      const recognised = await tools.recognise(bytes, name)
      if (recognised.kind !== 'archive' || depth === MAX_DEPTH)
        looked.found.push({ ...recognised, name, bytes })
      else {
        const within = await tools.unpack(bytes, name)
        // A single file in an archive is meant, whatever it is.
        if (within.length > 1) looked.loose = true
        for (const one of within) await look(one, looked, depth + 1)
      }
    }
  } catch (error) {
    looked.refused.push(error)
  }
}

/** The session or comparison in a PNG of ours; null for any other file. */
async function carriedBy(bytes: Uint8Array): Promise<string | null> {
  if (bytes[0] !== 137 || bytes[1] !== 80) return null
  const { textOfPng } = await import('../share/png')
  return textOfPng(bytes).catch((error: { kind?: string }) => {
    if (error.kind === 'picture-bare') return null
    throw error
  })
}

const OPENED = new Set([
  'carrier',
  'session',
  'comparison',
  'results',
  'movingai-scen',
  'tsplib',
  'tsplib-tour',
])
const canBeOpened = (file: FoundFile | Carrier) =>
  OPENED.has(file.kind) || (file.kind !== 'carrier' && file.map)

/** Whether there was anything to open. */
async function openFound(found: Looked['found'], opening: Together): Promise<boolean> {
  const files = found.filter((file): file is FoundFile => file.kind !== 'carrier')
  const named = await picturesNamed(files)
  const orders = files.filter(({ kind }) => kind === 'tsplib')
  const maps = files.filter((file) => file.map && !named.has(file))
  for (const file of found) {
    if (file.kind === 'carrier') await openText(file.text)
    else if (file.kind === 'session') await openSessionFile(file.bytes)
    else if (file.kind === 'comparison')
      await openComparisonText(new TextDecoder().decode(file.bytes))
    else if (file.kind === 'results') await importResults(file.bytes, file.name)
    // A tour alone: its import says so. As a rule the import says why it is no map.
    else if (!canBeOpened(file) || (file.kind === 'tsplib-tour' && orders.length === 0)) {
      const name = fileName(file.name)
      showMap(await tools.importMap(file.bytes, name), { name, take: null })
    }
  }
  const [order, ...moreOrders] = orders
  if (order) await openOrder(order, files)
  tellLeftOut(moreOrders, 'opening.oneOrder')
  const scens = files.filter(({ kind }) => kind === 'movingai-scen')
  const [first] = maps
  if (maps.length > 1 && !opening.unasked)
    mapChoice.value = { files: maps, others: files.filter((file) => !maps.includes(file)) }
  else if (first) await openOne(first, files, opening)
  else for (const scen of scens) await openScen(scen)
  return found.length > 0
}

/** One map of several that came together. */
export async function openChosen({ files, others }: MapChoice, file: FoundFile): Promise<void> {
  await openOne(file, [...files, ...others], {})
  mapChoice.value = null
}

/** An order problem, with the tour that is named as it is, or the only one. */
async function openOrder(file: FoundFile, together: FoundFile[]): Promise<void> {
  const tours = together.filter(({ kind }) => kind === 'tsplib-tour')
  const alike = tours.find(({ name }) => stemOf(name) === stemOf(file.name))
  const tour = alike ?? (tours.length === 1 ? tours[0] : null) ?? null
  const named = ({ name, bytes }: NamedBytes) => ({ name: fileName(name), bytes })
  await offerOrder(named(file), tour && named(tour))
}

/** Pictures that the description of a ROS map names: they are no maps of their own. */
async function picturesNamed(files: FoundFile[]): Promise<Set<FoundFile>> {
  const named = new Set<FoundFile>()
  for (const file of files) {
    if (file.kind !== 'ros-map') continue
    const image = pictureOf(file, await nameOfPicture(file), files)
    if (image) named.add(image)
  }
  return named
}

/** Empty where the description is broken: its import says how. */
const nameOfPicture = (file: NamedBytes) => tools.rosImage(file.bytes).catch(() => '')

/** Of several of the same name, the one in the folder of the description. */
function pictureOf(map: FoundFile, image: string, files: FoundFile[]): FoundFile | undefined {
  const alike = files.filter(({ name, kind }) => kind === 'picture' && sameName(name, image))
  return alike.find(({ name }) => folderOf(name) === folderOf(map.name)) ?? alike[0]
}

async function openOne(file: FoundFile, together: FoundFile[], opening: Together): Promise<void> {
  const asked = !opening.unasked
  const named = { ...file, name: fileName(file.name) }
  const take = opening.take ?? null
  if (file.raster && asked) return offerTerrain(named, take)
  const needs = file.kind === 'ros-map' ? await nameOfPicture(file) : ''
  const image = needs === '' ? null : (pictureOf(file, needs, together) ?? null)
  const matrices = file.kind === 'matrix' && asked ? await matricesOf(file) : []
  const scens = together.filter(({ kind }) => kind === 'movingai-scen')
  const map: MapFile = {
    ...named,
    matrices,
    image,
    needs: image ? null : needs || null,
    scens,
    take,
  }
  const leavesChoice = ASKED.has(file.kind) || !file.certain || matrices.length > 1
  if (asked && leavesChoice && file.kind !== 'unknown') mapFile.value = map
  else await openMap(map, {})
}

/** None where they cannot be told: the import says why. */
const matricesOf = ({ bytes }: NamedBytes) => tools.listMatrices(bytes).catch(() => [])

/** The map as the reader wants it. */
export const readMap = ({ bytes, name, image }: MapFile, choices: ReadOptions) =>
  tools.importMap(bytes, name, choices, image?.bytes)

/** Opens the map of a file that left a choice; it stays offered until it could be read. */
export async function openMap(file: MapFile, choices: ReadOptions, read?: Imported): Promise<void> {
  const imported = read ?? (await readMap(file, choices))
  // Notices about start and goal are left out when a .scen is about to set them.
  const told = imported.warnings.filter(
    ({ kind }) => !(file.scens.length > 0 && kind === 'ends-chosen'),
  )
  showMap({ ...imported, warnings: told }, file)
  if (file.take === null) for (const scen of file.scens) await openScen(scen)
}

/** The chosen part of a raster of heights. */
export async function openTerrain(file: TerrainFile, part: TerrainPart): Promise<void> {
  showMap(await importPart(file, part), file)
}

function showMap(imported: Imported, { name, take }: { name: string; take: Taker | null }): void {
  mapFile.value = null
  mapChoice.value = null
  const opened = toScenario(imported, name)
  if (take) take(opened)
  else {
    suitSpeed(opened)
    setScenario(opened, { undoable: true })
  }
  const { width, height } = imported.spec
  notify('success', t('opening.imported', { name, width, height }), {
    hint: imported.warnings.map(describeNotice).join(' '),
  })
}

async function openScen(file: NamedBytes): Promise<void> {
  const name = fileName(file.name)
  const { lines, warnings } = await tools.importScen(file.bytes)
  const now = scenario.peek()?.spec
  const fitting = lines.filter((line) => line.width === now?.width && line.height === now.height)
  const [wanted] = lines
  if (fitting.length === 0 && wanted) {
    const { map, width, height } = wanted
    notify('warning', t('opening.scenNeedsMap', { name, map, width, height }), {
      hint: t('opening.scenNeedsMapHint'),
    })
    return
  }
  if (warnings.length > 0) notify('warning', warnings.map(describeNotice).join(' '))
  scenChoice.value = { fileName: name, lines: fitting }
}

export function chooseScen(line: ScenLine): void {
  const now = scenario.peek()
  scenChoice.value = null
  if (!now) return
  const goals = [goalAt(line.goal, now.spec.goals[0]?.name ?? 'goal')]
  const chosen = { ...now, spec: { ...now.spec, start: line.start, goals } }
  setScenario(liftEnds(chosen) ?? chosen, { undoable: true })
}

async function openSessionFile(bytes: Uint8Array): Promise<void> {
  const { sessionFromFile } = await sessionFormat()
  replay(await sessionFromFile(new TextDecoder().decode(bytes)))
}

/** Opens a comparison in the laboratory. */
async function openComparisonText(text: string): Promise<void> {
  const { openComparisonDocument } = await lazyParts.lab()
  showView('lab')
  await openComparisonDocument(text)
}

/** Imports a file of results into the laboratory. */
async function importResults(bytes: Uint8Array, name: string): Promise<void> {
  const { takeImportedResults } = await lazyParts.lab()
  showView('lab')
  await takeImportedResults(fileName(name), bytes)
}

function replay(session: Session): void {
  showView('race')
  loadSession(session)
  autoplay()
}

const fileName = (path: string) => path.slice(Math.max(...folderEnds(path)) + 1)
const stemOf = (path: string) => fileName(path).toLowerCase().split('.')[0]
const folderOf = (path: string) => path.slice(0, Math.max(0, ...folderEnds(path)))
const folderEnds = (path: string) => [path.lastIndexOf('/'), path.lastIndexOf('\\')]
const sameName = (a: string, b: string) => fileName(a).toLowerCase() === fileName(b).toLowerCase()
