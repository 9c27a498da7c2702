/** Files in and out: recognises what was dropped, pasted or chosen, and puts it where it belongs. */

import type { ExportFormat, Imported, ScenLine } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { tools } from '../engine/tools'
import { t } from '../i18n'
import { describeNotice } from '../i18n/errors'
import { heightsOf } from '../model/height_bytes'
import { goalAt, type Scenario, type Session } from '../model/session'
import { liftEnds } from '../model/terrain'
import type { TerrainPart } from '../model/tool_calls'
import { bytesOf, refuseLarge } from './file_bytes'
import { lazyParts } from './lazy_parts'
import { notify, notifyError } from './notices'
import { showView } from './page_view'
import { setScenario } from './scenarios'
import { autoplay, currentSession, loadSession } from './sessions'
import { suitSpeed } from './speed'
import { engineVersion, scenario } from './store'
import { importPart, offerTerrain, type TerrainFile } from './terrain_files'

export interface ScenChoice {
  fileName: string
  lines: ScenLine[]
}

/** Scenarios of a .scen file, waiting for the reader to choose one. */
export const scenChoice = signal<ScenChoice | null>(null)
/** Reading and writing sessions is fetched when it is first needed: most visits only watch. */
const sessionFormat = () => import('../share/link')

interface Opening {
  /** A .scen is about to say where start and goal lie. */
  scenFollows?: boolean
  /** Opens rasters of heights as they are, instead of asking which part of them. */
  unasked?: boolean
}

/** Opens what a file holds; refusals are thrown, and leave the page as it was. */
async function openFile(bytes: Uint8Array, name: string, opening: Opening = {}): Promise<void> {
  if (isPicture(bytes)) {
    const { textOfPng } = await import('../share/png')
    return openText(await textOfPng(bytes))
  }
  const { kind, raster } = await tools.sniff(bytes, name)
  if (kind === 'session') await openSessionFile(bytes)
  else if (kind === 'comparison') await openComparisonText(new TextDecoder().decode(bytes))
  else if (kind === 'results') await importResults(bytes, name)
  else if (kind === 'movingai-scen') await openScen(bytes, name)
  else if (raster && !opening.unasked) await offerTerrain(bytes, name)
  else await openMap(bytes, name, opening)
}

/** Pasted or typed text: a share link, or the contents of any file we read. */
export async function openText(text: string, opening: Opening = {}): Promise<void> {
  refuseLarge(text.length, t('maps.pastedName'))
  // A file may contain a link, so only text that is no JSON is searched for one.
  const fragment = text.trimStart().startsWith('{') ? null : /#[xq]=[\w-]+/.exec(text)?.[0]
  if (fragment?.startsWith('#q')) {
    const { decodeFragment } = await import('../share/comparison_link')
    await openComparisonText(await decodeFragment(fragment))
  } else if (fragment) replay(await (await sessionFormat()).decodeFragment(fragment))
  else await openFile(new TextEncoder().encode(text), t('maps.pastedName'), opening)
}

/** Maps before scenarios, so that a .map and its .scen may be opened together. */
export async function openFiles(files: Iterable<File>): Promise<void> {
  const inOrder = [...files].sort((a, b) => Number(isScen(a)) - Number(isScen(b)))
  const scenFollows = inOrder.some(isScen)
  for (const file of inOrder) {
    await openFile(await bytesOf(file), file.name, { scenFollows })
  }
}

/** Like the functions above, but shows refusals as messages. True when all was opened. */
export const importFile = (bytes: Uint8Array, name: string) => shown(openFile(bytes, name))
export const importText = (text: string, opening?: Opening) => shown(openText(text, opening))
export const importFiles = (files: Iterable<File>) => shown(openFiles(files))

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
  await takeImportedResults(name, bytes)
}

/** Whether it is a PNG, by its first bytes. */
const isPicture = (bytes: Uint8Array) => bytes[0] === 137 && bytes[1] === 80

function replay(session: Session): void {
  showView('race')
  loadSession(session)
  autoplay()
}

async function shown(opening: Promise<void>): Promise<boolean> {
  try {
    await opening
    return true
  } catch (error) {
    notifyError(error)
    return false
  }
}

export function chooseScen(line: ScenLine): void {
  const now = scenario.peek()
  scenChoice.value = null
  if (!now) return
  const goals = [goalAt(line.goal, now.spec.goals[0]?.name ?? 'goal')]
  const chosen = { ...now, spec: { ...now.spec, start: line.start, goals } }
  setScenario(liftEnds(chosen) ?? chosen, { undoable: true })
}

export function exportMap(format: ExportFormat): Promise<string> {
  const now = scenario.peek()
  if (!now) return Promise.resolve('')
  // A .scen names the file of its map: the one that is downloaded.
  const named =
    format === 'movingai-scen' ? { ...now, spec: { ...now.spec, name: fileStem() } } : now
  return tools.exportMap(named, format)
}

export async function exportGeotiff(): Promise<Uint8Array> {
  const now = scenario.peek()
  return now ? tools.exportGeotiff(now) : new Uint8Array()
}

export async function exportSession(): Promise<string> {
  const { sessionToFile } = await sessionFormat()
  const session = currentSession()
  return session ? sessionToFile(session, engineVersion.peek()) : ''
}

export function download(name: string, content: string | Uint8Array, type = 'text/plain'): void {
  const url = URL.createObjectURL(new Blob([content as BlobPart], { type }))
  const anchor = document.createElement('a')
  anchor.href = url
  anchor.download = name
  anchor.click()
  setTimeout(() => URL.revokeObjectURL(url), 10_000)
}

/** The scenario's name, made fit for any file system. */
export function fileStem(): string {
  const name = scenario.peek()?.spec.name ?? ''
  return (
    name
      .replace(/\.\w+$/, '')
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-|-$/g, '')
      .toLowerCase() || 'map'
  )
}

async function openMap(bytes: Uint8Array, name: string, { scenFollows }: Opening): Promise<void> {
  const imported = await tools.importMap(bytes, name)
  // Notices about start and goal are left out when a .scen is about to set them.
  const told = imported.warnings.filter(({ kind }) => !(scenFollows && kind === 'ends-chosen'))
  showMap({ ...imported, warnings: told }, name)
}

/** The chosen part of a raster of heights. */
export async function openTerrain(file: TerrainFile, part: TerrainPart): Promise<void> {
  showMap(await importPart(file, part), file.name)
}

function showMap(imported: Imported, name: string): void {
  const opened = toScenario(imported, name)
  suitSpeed(opened)
  setScenario(opened, { undoable: true })
  const { width, height } = imported.spec
  notify('success', t('notices.imported', { name, width, height }), {
    hint: imported.warnings.map(describeNotice).join(' '),
  })
}

export function toScenario({ spec, cells, heights }: Imported, name: string): Scenario {
  return {
    spec: { ...spec, name: spec.name || name },
    cells,
    heights: heightsOf(heights),
    origin: null,
  }
}

async function openScen(bytes: Uint8Array, name: string): Promise<void> {
  const { lines, warnings } = await tools.importScen(bytes)
  const now = scenario.peek()?.spec
  const fitting = lines.filter((line) => line.width === now?.width && line.height === now.height)
  const [wanted] = lines
  if (fitting.length === 0 && wanted) {
    const { map, width, height } = wanted
    notify('warning', t('notices.scenNeedsMap', { name, map, width, height }), {
      hint: t('notices.scenNeedsMapHint'),
    })
    return
  }
  if (warnings.length > 0) notify('warning', warnings.map(describeNotice).join(' '))
  scenChoice.value = { fileName: name, lines: fitting }
}

const isScen = (file: File) => file.name.toLowerCase().endsWith('.scen')
