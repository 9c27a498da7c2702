/** What a figure is: something that can be drawn, read as a table, and said in a few words. */

import type { Drawing } from '../../figures/frame'
import type { Look, Series } from '../../figures/look'
import type { LabKey } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis, MapFronts } from '../../model/analysis'
import { labelOf } from '../words/numbers'
import { seriesOf } from './figure_style'

export type Plot = typeof import('./library')

export const FIGURES = [
  'values',
  'convergence',
  'targets',
  'effort',
  'gaps',
  'ablation',
  'ranks',
] as const
export type FigureId = (typeof FIGURES)[number]

/** What is drawn, and how large. */
export interface Scene {
  analysis: Analysis
  map: MapAnalysis
  /** Pixels. */
  width: number
  look: Look
  /** Whether effort is on a logarithmic scale. */
  logarithmic: boolean
  /** What the runs on the map trade off, for the figure that shows it. */
  fronts?: MapFronts | undefined
}

export interface FigureTable {
  columns: string[]
  rows: string[][]
}

export interface Figure {
  id: FigureId | 'fronts'
  /** About all maps together rather than one of them. */
  overall: boolean
  /** Whether the figure makes sense for such a comparison. */
  suits(analysis: Analysis): boolean
  /** Why there is nothing to draw yet. */
  missing(scene: Scene): LabKey | null
  draw(plot: Plot, scene: Scene): Drawing
  table(scene: Scene): FigureTable
  /** What it shows, in a few words, for screen readers. */
  words(scene: Scene): string
}

/** An entry with its place, by which it keeps its colour wherever it is shown. */
export interface Shown {
  index: number
  entry: EntryAnalysis
  series: Series
}

/** The entries of which there are runs. */
export function shownEntries(map: MapAnalysis): Shown[] {
  return map.entries.flatMap((entry, index) =>
    entry.runs > 0 ? [{ index, entry, series: seriesOf(index, labelOf(entry)) }] : [],
  )
}
