/** The path of a panel as a file for other programs. */
import type { Notice, PathFormatFacts } from '@pkg/formicarium'
import { lateTools } from '../engine/late_tools'
import { download, fileStem } from './export_files'
import { shownOf } from './looking'
import { type Panel, scenario } from './store'

/** Every format, with why the map on show cannot give it. */
export async function pathFormats(): Promise<PathFormatFacts[]> {
  const now = scenario.peek()
  return now ? lateTools.pathFormats(now.spec) : []
}

/** Saves the path on show, of the past where that is looked at; tells what the engine assumed. */
export async function savePath(panel: Panel, facts: PathFormatFacts): Promise<Notice[]> {
  const now = scenario.peek()
  const { bestPath, bestAltitudes, objective } = shownOf(panel)
  if (!now || !bestPath || !objective) return []
  const path = { path: pairs(bestPath), altitudes: bestAltitudes, objective }
  const { text, warnings } = await lateTools.writePath(now, path, facts.format)
  download(`${fileStem()}.${panel.setup.planner}${facts.ending}`, text, facts.media_type)
  return warnings
}

function pairs(flat: Uint32Array): [number, number][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0])
}
