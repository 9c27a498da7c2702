/** What the engine says of runs, under the names that are used here. */
import type { Ablated, Analysis as Said } from '@pkg/formicarium'

export type {
  Ablated,
  Axis,
  BandPoint,
  Difference,
  Effect,
  EntryAnalysis,
  EntryFront,
  FrontPoint,
  FrontQuestion,
  MapAnalysis,
  MapFronts,
  Matrix,
  MatrixCell,
  MatrixRow,
  Overall,
  OverMaps,
  Pair,
  PaperReading,
  Ranks,
  ResultFile,
  RunMeasure as Measure,
  Summary,
  UnfitMap,
  VerdictLine,
} from '@pkg/formicarium'

export interface Analysis extends Said {
  /** What each component does, on each map; empty where the question is no ablation, and while runs go on. */
  ablation: Ablated[]
}
