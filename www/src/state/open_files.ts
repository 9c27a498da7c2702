/** Files in: recognises what came together, and puts it where it belongs. */
import type { EngineError, Imported, ReadOptions, ScenLine } from '@pkg/formicarium'
import { effect } from '@preact/signals'
import { lateTools } from '../engine/late_tools'
import { tools } from '../engine/tools'
import { t } from '../i18n/dialogs'
import { describeError, describeNotice } from '../i18n/errors'
import { goalAt, type Scenario, type Session } from '../model/session'
import { liftEnds } from '../model/terrain'
import type { TerrainPart } from '../model/tool_calls'
import type { ToldByLink } from '../share/comparison_link'
import { linkIn } from '../share/link_in_text'
import { loadSession, notify, readied, scenario, setScenario, showView } from '.'
import { openPath, withBarePaths } from './brought_path'
import { closeDialog } from './dialogs'
import { bytesOf, MAX_BYTES, refuseLarge } from './file_bytes'
import { fileName, stemOf } from './file_paths'
import type { Opening } from './files'
import { filesWithin } from './folder_files'
import { toScenario } from './imported'
import { areJournals, contentOf, takeInJournals } from './journal_files'
import { lazyParts } from './lazy_parts'
import { LESSON_PREFIX } from './lesson'
import { canBeOpened, type Looked, lookAt } from './looked_files'
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
import { inTurn, isAsking, type Turn, tellNotOpened } from './openings'
import { offerOrder, takeTour } from './order_play'
import { nameOfPicture, pictureOf, picturesNamed, takePicture } from './ros_pictures'
import { autoplay } from './sessions'
import { suitSpeed } from './speed'
import { importPart, offerTerrain } from './terrain_files'

/** All files of a folder together. */
const MAX_TOTAL = 8 * MAX_BYTES

const sessionFormat = () => import('../share/link')

/** Kinds that leave a choice. */
export const ASKED = new Set(['picture', 'ros-map', 'occupancy-grid'])

/** Pasted or typed text: a share link, or the contents of any file we read. False if it was not opened, and the reader knows. */
export async function openText(text: string, opening: Opening = {}): Promise<boolean> {
  const name = t('opening.pastedName')
  refuseLarge(text.length, name)
  if (!opening.unasked && isAsking()) return joinAsked([{ name, bytes: encoded(text) }])
  return inTurn([name], (turn) => openTextIn(turn, text, opening))
}

async function openTextIn(
  turn: Turn,
  text: string,
  opening: Opening,
  name = t('opening.pastedName'),
): Promise<void> {
  const fragment = linkIn(text)
  if (fragment?.startsWith('#q')) {
    const { decodeFragment } = await import('../share/comparison_link')
    const { document, ...told } = await decodeFragment(fragment)
    await openComparisonText(turn, document, told)
  } else if (fragment?.startsWith(LESSON_PREFIX)) {
    const { lessonSession, showLesson } = await import('./gallery_lessons')
    const id = fragment.slice(LESSON_PREFIX.length)
    const session = await lessonSession(id)
    turn.check()
    showLesson(id, session)
  } else if (fragment)
    replay(turn, await readied(await (await sessionFormat()).decodeFragment(fragment)))
  else await openTogether(turn, [{ name, bytes: encoded(text) }], opening)
}

const encoded = (text: string) => new TextEncoder().encode(text)

/** False if not all of them were opened, and the reader knows. */
export async function openFiles(files: File[]): Promise<boolean> {
  if (isAsking()) return joinAsked(await contentsOf(files))
  if (areJournals(files)) {
    await takeInJournals(files)
    return true
  }
  const names = files.map(({ name }) => name)
  return inTurn(names, async (turn) => openTogether(turn, await contentsOf(files)))
}

/** While a dialog asks about a file, only what belongs to that file is taken in. */
async function joinAsked(given: NamedBytes[]): Promise<boolean> {
  const taken = (await takePicture(given)) ?? (await takeTour(given))
  const others = given.filter((file) => file !== taken)
  tellNotOpened(others.map(({ name }) => fileName(name)))
  return others.length === 0
}

/** Opens files as maps alone, each of them, and hands them to `take` instead of the race. */
export async function openMapsFor(files: File[], take: Taker): Promise<void> {
  const names = files.map(({ name }) => name)
  await inTurn(names, async (turn) => {
    const { found, refused, nested } = await lookAt(await contentsOf(files))
    const all = found.filter((file): file is FoundFile => file.kind !== 'carrier')
    const named = await picturesNamed(all)
    const maps = all.filter((file) => (file.map || file.kind === 'unknown') && !named.has(file))
    for (const file of maps) {
      await openOne(turn, file, all, { take })
      turn.rest()
      await answered()
    }
    const [first] = [...refused, ...nested]
    if (first !== undefined) throw first
    if (maps.length === 0) throw nothingWithin(names[0] ?? '')
  })
}

async function contentsOf(files: File[]): Promise<NamedBytes[]> {
  const given: NamedBytes[] = []
  for (const file of files) given.push({ name: file.name, bytes: await contentOf(file) })
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

/** What was dropped, folders too. A dialog that asks about no file gives way. */
export function openDropped(files: File[], entries: FileSystemEntry[]): Promise<boolean> {
  if (!isAsking()) closeDialog()
  return entries.some((entry) => entry.isDirectory) ? openEntries(entries) : openFiles(files)
}

/** Files and folders, with what lies in them. */
async function openEntries(entries: FileSystemEntry[]): Promise<boolean> {
  const names = entries.map(({ name }) => name)
  if (isAsking()) {
    tellNotOpened(names)
    return false
  }
  return inTurn(names, async (turn) => {
    const given: NamedBytes[] = []
    let total = 0
    for (const { path, file } of await filesWithin(entries)) {
      total += file.size
      if (total > MAX_TOTAL) break
      if (file.size <= MAX_BYTES) given.push({ name: path, bytes: await bytesOf(file) })
    }
    await openTogether(turn, given, { loose: true })
  })
}

interface Together extends Opening {
  /** Where a map goes instead of the race. */
  take?: Taker
  /** They lay in a folder or archive: what cannot be opened is passed over. */
  loose?: boolean
}

/** Opens files that came together. Refusals are thrown, and leave the page as it was. */
async function openTogether(
  turn: Turn,
  given: NamedBytes[],
  opening: Together = {},
): Promise<void> {
  const { found, refused, nested, loose } = await lookAt(given, opening.loose)
  turn.check()
  const known = found.filter(canBeOpened)
  // Of an archive that holds nothing but another one, that is what is wrong.
  if (known.length === 0 && nested.length > 0) throw nested[0]
  const opened = await openFound(turn, loose || known.length > 0 ? known : found, opening)
  if (!loose && opened && known.length > 0) tellLeftOut(found.filter((file) => !canBeOpened(file)))
  for (const { message, hint } of nested.map(describeError)) notify('warning', message, { hint })
  if (refused.length > 0 && !(loose && opened)) throw refused[0]
  if (!opened) throw nothingWithin(given[0]?.name ?? '')
}

/** Of files that were named one by one, the reader hears which are none of ours. */
function tellLeftOut(
  files: NamedBytes[],
  why: 'opening.leftOut' | 'opening.oneOrder' | 'opening.onePath' = 'opening.leftOut',
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

/** Whether there was anything to open. */
async function openFound(turn: Turn, found: Looked['found'], opening: Together): Promise<boolean> {
  const files = await withBarePaths(
    found.filter((file): file is FoundFile => file.kind !== 'carrier'),
  )
  const named = await picturesNamed(files)
  const orders = files.filter(({ kind }) => kind === 'tsplib')
  const maps = files.filter((file) => file.map && !named.has(file))
  for (const file of found) {
    if (file.kind === 'carrier') await openTextIn(turn, file.text, {}, file.name)
    else if (file.kind === 'session') await openSessionFile(turn, file.bytes)
    else if (file.kind === 'comparison')
      await openComparisonText(turn, new TextDecoder().decode(file.bytes))
    else if (file.kind === 'results') await importResults(turn, file.bytes, file.name)
    // A tour alone: its import says so. As a rule the import says why it is no map.
    else if (!canBeOpened(file) || (file.kind === 'tsplib-tour' && orders.length === 0)) {
      const name = fileName(file.name)
      const imported = await tools.importMap(file.bytes, name)
      turn.check()
      showMap(imported, { name, take: null })
    }
  }
  await takeInFound(turn, files)
  const [order, ...moreOrders] = orders
  if (order) await openOrder(turn, order, files)
  tellLeftOut(moreOrders, 'opening.oneOrder')
  const scens = files.filter(({ kind }) => kind === 'movingai-scen')
  turn.check()
  const [first] = maps
  if (maps.length > 1 && !opening.unasked)
    mapChoice.value = { files: maps, others: files.filter((file) => !maps.includes(file)) }
  else if (first) await openOne(turn, first, files, opening)
  else for (const scen of scens) await openScen(scen, turn)
  await openPathOf(turn, files)
  return found.length > 0
}

/** One path at a time, and none while a dialog asks about its map. */
async function openPathOf(turn: Turn, files: FoundFile[]): Promise<void> {
  const paths = files.filter(({ kind }) => kind === 'path')
  const [first, ...others] = isAsking() ? [] : paths
  if (first) await openPath(turn, first)
  tellLeftOut(first ? others : paths, 'opening.onePath')
}

/** One map of several that came together. */
export async function openChosen({ files, others }: MapChoice, file: FoundFile): Promise<void> {
  await inTurn([fileName(file.name)], async (turn) => {
    await openOne(turn, file, [...files, ...others], {})
    mapChoice.value = null
  })
}

/** An order problem, with the tour that is named as it is, or the only one. */
async function openOrder(turn: Turn, file: FoundFile, together: FoundFile[]): Promise<void> {
  const tours = together.filter(({ kind }) => kind === 'tsplib-tour')
  const alike = tours.find(({ name }) => stemOf(name) === stemOf(file.name))
  const tour = alike ?? (tours.length === 1 ? tours[0] : null) ?? null
  const named = ({ name, bytes }: NamedBytes) => ({ name: fileName(name), bytes })
  await offerOrder(named(file), tour && named(tour), () => turn.check())
}

async function openOne(
  turn: Turn,
  file: FoundFile,
  together: FoundFile[],
  opening: Together,
): Promise<void> {
  const asked = !opening.unasked
  const named = { ...file, name: fileName(file.name) }
  const take = opening.take ?? null
  if (file.raster && asked) return offerTerrain(named, take, () => turn.check())
  const needs = file.kind === 'ros-map' ? await nameOfPicture(file) : ''
  const image = needs === '' ? null : (pictureOf(file, needs, together) ?? null)
  const matrices = file.kind === 'matrix' && asked ? await matricesOf(file) : []
  const scens = together.filter(({ kind }) => kind === 'movingai-scen')
  const map: MapFile = {
    ...named,
    matrices,
    swamp: false,
    image,
    names: needs,
    needs: image ? null : needs || null,
    scens,
    take,
  }
  const leavesChoice = ASKED.has(file.kind) || !file.certain || matrices.length > 1
  turn.check()
  if (asked && leavesChoice && file.kind !== 'unknown') {
    mapFile.value = map
    return
  }
  const read = await readMap(map, {})
  turn.check()
  if (asked && hasSwamp(read)) mapFile.value = { ...map, swamp: true }
  else await openMap(map, {}, read)
}

const hasSwamp = ({ warnings }: Imported) => warnings.some(({ kind }) => kind === 'swamp')

/** None where they cannot be told: the import says why. */
export const matricesOf = ({ bytes }: NamedBytes) => lateTools.listMatrices(bytes).catch(() => [])

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

async function openScen(file: NamedBytes, turn?: Turn): Promise<void> {
  const name = fileName(file.name)
  const { lines, warnings } = await tools.importScen(file.bytes)
  turn?.check()
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
  if (now) setScenario(withEnds(now, line), { undoable: true })
}

/** The map with the start and goal of a line. */
export function withEnds(now: Scenario, line: ScenLine): Scenario {
  const goals = [goalAt(line.goal, now.spec.goals[0]?.name ?? 'goal')]
  const chosen = { ...now, spec: { ...now.spec, start: line.start, goals } }
  return liftEnds(chosen) ?? chosen
}

async function openSessionFile(turn: Turn, bytes: Uint8Array): Promise<void> {
  const { sessionFromFile } = await sessionFormat()
  replay(turn, await readied(await sessionFromFile(new TextDecoder().decode(bytes))))
}

/** Opens a comparison in the laboratory. */
async function openComparisonText(turn: Turn, text: string, told?: ToldByLink): Promise<void> {
  const { openComparisonDocument } = await lazyParts.lab()
  turn.check()
  showView('lab')
  await openComparisonDocument(text, told)
}

/** Imports a file of results into the laboratory. */
async function importResults(turn: Turn, bytes: Uint8Array, name: string): Promise<void> {
  const { takeImportedResults } = await lazyParts.lab()
  turn.check()
  showView('lab')
  await takeImportedResults(fileName(name), bytes)
}

/** Takes in the journals among files that came together, such as the archive of a whole class. */
async function takeInFound(turn: Turn, files: FoundFile[]): Promise<void> {
  const journals = files.filter(({ kind }) => kind === 'journal')
  if (journals.length === 0) return
  const { takeJournalFiles } = await lazyParts.lab()
  turn.check()
  showView('lab')
  await takeJournalFiles(
    journals.map(({ name, bytes }) => ({ name: fileName(name), read: async () => bytes })),
  )
}

function replay(turn: Turn, session: Session): void {
  turn.check()
  showView('race')
  loadSession(session)
  autoplay()
}
