/**
 * Everything that crosses between the page's thread and a panel's worker.
 *
 * Each panel owns one worker, one wasm instance and one OffscreenCanvas. Requests that concern a run carry its `runId`; replies
 * repeat it, so that an answer to a run that has been replaced meanwhile is dropped.
 */
import type {
  Certificate,
  EngineError,
  Layer,
  RunSummary,
  ScenarioSpec,
  Smoothed,
  Status,
  Walls,
} from '@pkg/formicarium'
import type { Stop } from './lesson'
import type { MapCells } from './session'

/** Parameter values by key, as the catalog names them; what is absent takes the catalog's default. */
export type ParamValues = Record<string, number | string | boolean>

/** What a run is made of: enough to repeat it bit for bit. */
export interface RunSetup extends MapCells {
  spec: ScenarioSpec
  planner: string
  params: ParamValues
  seed: number
  /** Iterations to be run at once. */
  ahead?: number
}

/** The values that the first and the last colour of a layer stand for. */
export type LayerEnds = [low: number, high: number]

/** How a panel looks at the map. Place and zoom are the same in every panel, so that maps can be compared cell by cell. */
export interface PanelView {
  /** Canvas size in device pixels. */
  width: number
  height: number
  /** Device pixels per cell and the position of the map's upper left corner in device pixels. */
  scale: number
  originX: number
  originY: number
  /** Device pixels per CSS pixel: line widths and markers scale with it. */
  dpr: number
  layer: Layer | 'none'
  /** Of layers that all panels draw by one scale; any other goes from its own least value to its greatest. */
  ends: Partial<Record<Layer, LayerEnds>>
  showAnts: boolean
  showPath: boolean
  /** Lines of equal height on a terrain. */
  showContours: boolean
  /** The panel shows something else; nothing is drawn until it is back. */
  hidden: boolean
  theme: 'light' | 'dark'
  /** Hex colour of this panel's planner, for its path. */
  colour: string
  /** Names of the goals: they may change while a run goes on. */
  goalNames: string[]
  /** Cell under the pointer or the keyboard cursor, [x, y]. */
  cursor: [number, number] | null
  /** Draw the cursor as a focus ring (keyboard) rather than a hover tint. */
  cursorFocus: boolean
}

/**
 * How far one tick may take a run. `moves` and `iterations` are counts to add; the `until-*` targets are absolute, so panels
 * that share a target stay in lockstep; `slice` runs until the time slice is spent. Counted moves are always made in full,
 * unless an absolute bound beside them is met first: that is how panels walk step by step and still keep a shared target.
 */
export type Target =
  | { kind: 'moves'; count: number; untilIteration?: number; untilPaths?: number }
  | { kind: 'iterations'; count: number }
  | { kind: 'until-iteration'; iteration: number }
  | { kind: 'until-paths'; paths: number }
  | { kind: 'slice' }

export type PanelRequest =
  | { kind: 'init'; module: WebAssembly.Module; canvas: OffscreenCanvas; view: PanelView }
  /** Replaces the run. The map is shown at once; the planner allocates at its first step. */
  | { kind: 'load'; runId: number; setup: RunSetup }
  | { kind: 'view'; view: PanelView }
  /** Advance towards `target`, at most `sliceMs` and no further than to a stop, draw once, answer with a `frame`. */
  | { kind: 'tick'; runId: number; target: Target; sliceMs: number; stops?: Stop[] | undefined }
  /** Answer with a `raster` of how things stand. */
  | { kind: 'raster' }
  /** Answered by an `answer` with the same `id`. */
  | { kind: 'ask'; runId: number; id: number; question: PanelQuestion }

/** What a panel's worker can be asked about its run. */
export type PanelQuestion =
  /** Look back: show the run as at the end of an iteration, until the next tick; null shows where it stands. */
  | { about: 'look'; iteration: number | null }
  /** The moves of an ant from a cell, by slices at a level; null for the level at which there is most to tell. */
  | { about: 'moves'; cell: [number, number]; level: number | null }
  /** The values of a layer, row by row; empty where the planner has no such layer. */
  | { about: 'layer'; layer: Layer }
  /** The smooth curve of the path on show. */
  | { about: 'curve' }
  /** What the planner has proven of its result. */
  | { about: 'certificate' }
  /** What is kept to look back. */
  | { about: 'kept' }
  /** The map as the panel would draw it in a theme, with a layer or without. */
  | ({ about: 'picture'; size: [width: number, height: number] } & Pick<
      PanelView,
      'layer' | 'ends' | 'theme'
    >)
  /** The panel as it would be drawn in this view, with ants so far through their last move, from 0 to 1. */
  | { about: 'shot'; view: PanelView; glide: number }
  /** Change walls at the end of the iteration at work. */
  | { about: 'walls'; walls: Walls }
  /** Paint the map as it would be with these walls. */
  | { about: 'show-walls'; walls: Walls }

/** What is answered to each question; null where there is no answer, e.g. because the run has been replaced meanwhile. */
export interface PanelAnswers {
  look: { summary: RunSummary; bestPath: Uint32Array; bestAltitudes: Float64Array }
  moves: {
    /** By slices the level of the place, else 0. */
    level: number
    /** Eight numbers each, as `Run.moves_from` gives them. */
    rows: Float64Array
  }
  layer: Float32Array
  /** With the path that it belongs to; null where there is none. */
  curve: { path: Uint32Array; curve: Smoothed | null }
  /** With the digest of the run as it stood; null where nothing is proven. */
  certificate: { digest: string; certificate: Certificate | null }
  kept: {
    snapshots: number
    bytes: number
    /** Most iterations that a look back computes again. */
    mostRepeated: number
  }
  picture: MapPicture
  shot: ImageBitmap
  walls: {
    /** The iteration at whose end they change; null where this build of the engine cannot change walls. */
    at: number | null
    /** Whether the planner goes on with what it has learnt; null where `at` is. */
    adapts: boolean | null
  } & PanelAnswers['look']
  'show-walls': null
}

/** A map and a layer over it, one pixel a cell. */
export interface MapPicture {
  /** Red, green, blue, opacity. */
  pixels: Uint8ClampedArray<ArrayBuffer>
  scale: LayerScale
}

/** Which layer a panel shows, and its least and greatest value over the free cells; null where it has none. */
export interface LayerScale {
  layer: Layer | 'none'
  own: LayerEnds | null
}

/** What a tick or a load did. */
export interface Frame {
  kind: 'frame'
  runId: number
  status: Status
  summary: RunSummary
  /** New rows of the history since the last frame: iteration, best so far, iteration best, mean, worst, arrived (6 numbers each; NaN = none). */
  history: Float64Array
  /** True when the target was reached (or the run has finished, or met a stop); false when the slice ended first. */
  reached: boolean
  /** The stops that were met; absent where none was asked for. */
  met?: Stop[] | undefined
  /** Best path as x0, y0, x1, y1, … when it changed since the last frame. */
  bestPath: Uint32Array | null
  /** Altitude in metres of each place of `bestPath`, empty on a plane; null when the path is. */
  bestAltitudes: Float64Array | null
  /** Milliseconds this tick took in the worker. */
  workMs: number
}

/** What lies on a terrain, to be drawn in three dimensions. */
export interface RasterReply {
  kind: 'raster'
  /** One pixel a cell, without light and shade; clear where there is no data. */
  bitmap: ImageBitmap
  /** x0, y0, x1, y1, …: cells of the ants that are under way. */
  ants: Uint32Array
}

export type PanelReply =
  | { kind: 'ready' }
  | { kind: 'answer'; id: number; answer: PanelAnswers[keyof PanelAnswers] | null }
  | RasterReply
  | Frame
  /** The layer on show, or its values, have changed. */
  | ({ kind: 'scale' } & LayerScale)
  /** The request was refused; the panel shows the map alone. */
  | { kind: 'refused'; runId: number; error: EngineError }
  /** The worker itself has failed, or could not be fetched. */
  | { kind: 'failed'; error: EngineError }
