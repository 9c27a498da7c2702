/** A path of a file, which becomes the path by hand on the map on show (lesson/drawing.ts). */
import type { EngineError } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { lateTools } from '../engine/late_tools'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import type { Cell } from '../model/cell'
import { sameCell } from '../model/edit'
import { type DrawnPath, LONGEST_LABEL, MOST_CELLS_DRAWN } from '../model/lesson'
import type { Scenario } from '../model/session'
import { key } from '../model/settle_ends'
import { liftEnds } from '../model/terrain'
import { fileName } from './file_paths'
import { lazyParts } from './lazy_parts'
import { notify, type Toast } from './notices'
import type { FoundFile, NamedBytes } from './offered_files'
import type { Turn } from './openings'
import { showView } from './page_view'
import { applyEdit } from './scenarios'
import { scenario } from './store'

/** The first line of a list of pairs. */
const PAIR = /^\s*\d+[ \t]*[,;\s][ \t]*\d+[ \t]*[\r\n]/
const OTHER_THAN_WALLS = /[2-9]|\d\d/

/** Null again once the lesson has taken it. */
export const broughtPath = signal<DrawnPath | null>(null)

/** Throws for what is no path, and where it does not lie on the map. */
export async function openPath(turn: Turn, { name, bytes }: NamedBytes): Promise<void> {
  const now = scenario.peek()
  if (!now) return
  const [{ path, warnings }] = await Promise.all([
    lateTools.readPath(now.spec, bytes),
    lazyParts.lesson('tools'),
  ])
  turn.check()
  if (path.length > MOST_CELLS_DRAWN) throw tooLong(name, path.length)
  showView('race')
  const file = fileName(name)
  const label = (file.split('.')[0] || file).slice(0, LONGEST_LABEL)
  broughtPath.value = { label, path }
  notify('success', t('opening.pathBrought', { name: file, map: now.spec.name }), {
    hint: warnings.map(describeNotice).join(' '),
    action: toItsEnds(now, path),
  })
}

/** Where it does not lead from the start to the only goal, though one could stand on its ends: they may come to it. */
function toItsEnds({ spec, cells }: Scenario, path: Cell[]): Toast['action'] {
  const [first, last] = [path[0], path.at(-1)]
  const [goal, another] = spec.goals
  if (!first || !last || !goal || another || sameCell(first, last)) return null
  if (sameCell(first, spec.start) && sameCell(last, goal.at)) return null
  if ([first, last].some((end) => cells[key(end, spec.width)] === 1)) return null
  const make = (map: Scenario) =>
    liftEnds({ ...map, spec: { ...map.spec, start: first, goals: [{ ...goal, at: last }] } }) ?? map
  return { label: t('opening.pathEnds'), run: () => applyEdit({ kind: 'make', make }) }
}

/** Two columns of numbers, not only 0 and 1, are a path where they go step by step over cells of the map on show: no map is so narrow. */
export const withBarePaths = (files: FoundFile[]): Promise<FoundFile[]> =>
  Promise.all(
    files.map(async (file) =>
      (await isBarePath(file)) ? { ...file, kind: 'path', raster: false, map: false } : file,
    ),
  )

async function isBarePath({ bytes, kind }: FoundFile): Promise<boolean> {
  const now = scenario.peek()
  if (!now || (kind !== 'matrix' && kind !== 'height-table')) return false
  const text = new TextDecoder().decode(bytes)
  if (!PAIR.test(text) || !OTHER_THAN_WALLS.test(text)) return false
  return lateTools.readPath(now.spec, bytes).then(
    ({ warnings }) => warnings.length === 0,
    () => false,
  )
}

function tooLong(field: string, count: number): EngineError {
  const message = t('opening.pathTooLong', { count, most: MOST_CELLS_DRAWN })
  return { kind: 'path-too-long', field, message, hint: t('opening.pathTooLongHint'), args: {} }
}
