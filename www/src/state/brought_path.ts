/** A path of a file, which becomes the path by hand on the map on show (lesson/drawing.ts). */
import type { EngineError } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { lateTools } from '../engine/late_tools'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import { type DrawnPath, LONGEST_LABEL, MOST_CELLS_DRAWN } from '../model/lesson'
import { fileName } from './file_paths'
import { lazyParts } from './lazy_parts'
import { notify } from './notices'
import type { FoundFile, NamedBytes } from './offered_files'
import type { Turn } from './openings'
import { showView } from './page_view'
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
  })
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
