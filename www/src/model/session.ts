/** What a session is: a race as it is shared. A link, a session file and undo bring all of it back. */
import type { Generator, Goal, Layer, ScenarioSpec, Status } from '@pkg/formicarium'
import type { Cell } from './cell'
import { layers } from './facts'
import type { Lesson } from './lesson'
import type { ParamValues } from './messages'

/** How the panels keep step while they play. */
export type Sync = 'moves' | 'iterations' | 'paths' | 'time'

/** Where a map came from, when that is shorter than its cells: the same generator call gives the same bits everywhere. */
export interface Origin {
  generator: Generator
  seed: number
  /** Share of obstacles; of a terrain its roughness. */
  density: number
}

/** A goal like any other: area, strength and danger are 1. */
export function goalAt(at: [number, number], name: string): Goal {
  return { at, name, area: 1, strength: 1, danger: 1 }
}

/** What is known of each cell, row by row from the upper left. With other factors a map has another list of cells too, which tells them apart. */
export interface MapCells {
  /** 1 = blocked. */
  cells: Uint8Array
  /** Of a terrain in the file's unit, NaN where there is no data; null on a plane. They come with `spec.terrain`, and never without. */
  heights: Float32Array | null
  /** By how much a way through the cell counts more than its length, at least 1; null where all are 1, and on a terrain. */
  factors: Float32Array | null
}

/** One map and the question asked on it. */
export interface Scenario extends MapCells {
  spec: ScenarioSpec
  origin: Origin | null
}

/** A recorded result, so that it can be verified: after `iterations`, the digest was `digest`. */
export interface RecordedResult {
  iterations: number
  status: Status
  length: number | null
  digest: string
}

export interface PanelSetup {
  /** Catalog id of the planner. */
  planner: string
  preset: string | null
  /** Only the values that differ from the catalog's defaults. */
  params: ParamValues
  /** As the reader calls it; null: by what it does. */
  label: string | null
  result: RecordedResult | null
}

/** The cell whose moves are on show, in the panel of this number, from 0 on; by slices at a level, null elsewhere. */
export interface InspectedCell {
  panel: number
  cell: Cell
  level: number | null
}

/** What of the race was looked at when it was shared: an iteration of the past, null for the present, and a cell. */
export interface Look {
  look: number | null
  inspected: InspectedCell | null
}

/** What the reader calls a session, and says of it; empty where nothing is said. */
export interface Caption {
  /** One line. */
  title: string
  /** Plain text with line breaks. */
  note: string
}

/** Walls that changed while the runs went on. */
export interface WallChange {
  blocked: Cell[]
  freed: Cell[]
  /** The iteration at whose end it was made, for each panel's run; 0 = before the first. */
  at: number[]
}

export interface Session extends Caption, Look {
  /** On the map as the changes have left it. */
  scenario: Scenario
  /** In their order; absent where the walls stayed as they were. */
  changes?: WallChange[]
  /** Whether further changes of walls keep the trails; absent where runs start anew. */
  keepTrails?: true
  panels: PanelSetup[]
  /** One seed for every panel: paired runs. */
  seed: number
  sync: Sync
  /** Index into SPEEDS. */
  speed: number
  layer: LayerChoice
  /** Absent where it carries nothing for a lesson. */
  lesson?: Lesson | undefined
}

/** What may lie under ants and paths. */
export type LayerChoice = Layer | 'none'

/** In the order of the menu. */
export const layerChoices = (known = layers): LayerChoice[] => [...known, 'none']

export const MAX_PANELS = 6

/** How much every panel does per frame of animation. */
export interface Speed {
  id: string
  /** `max`: as much as a time slice holds. */
  unit: 'move' | 'iteration' | 'max'
  count: number
  /** One round every this many frames. */
  everyFrames: number
}

/** Slowest first. A move: every living ant takes one step, an exact planner expands one cell. */
export const SPEEDS: readonly Speed[] = [
  { id: 'move-8', unit: 'move', count: 1, everyFrames: 8 },
  { id: 'move-2', unit: 'move', count: 1, everyFrames: 2 },
  { id: 'move', unit: 'move', count: 1, everyFrames: 1 },
  { id: 'moves-4', unit: 'move', count: 4, everyFrames: 1 },
  { id: 'moves-16', unit: 'move', count: 16, everyFrames: 1 },
  { id: 'moves-64', unit: 'move', count: 64, everyFrames: 1 },
  { id: 'iteration', unit: 'iteration', count: 1, everyFrames: 1 },
  { id: 'iterations-4', unit: 'iteration', count: 4, everyFrames: 1 },
  { id: 'max', unit: 'max', count: 1, everyFrames: 1 },
]

/** Slow enough to watch ants walk, fast enough to see them agree on a corridor within half a minute. */
export const DEFAULT_SPEED = 3
/** Of a first visit, until ants have arrived: four times as fast. */
export const LEAD_IN_SPEED = DEFAULT_SPEED + 1
/** The slowest that counts iterations. */
export const ITERATION_SPEED = SPEEDS.findIndex(({ unit }) => unit === 'iteration')
