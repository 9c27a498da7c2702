/** What a tools worker can do, and how it is asked: the calls that belong to no panel. */
import type {
  AblationEntry,
  Catalog,
  EngineError,
  ExportFormat,
  Figure,
  Generated,
  Generator,
  Imported,
  Lattice,
  Layer,
  MatrixInfo,
  Notice,
  Objective,
  PathFormat,
  PathFormatFacts,
  PathSteps,
  PathText,
  ReadOptions,
  Recognised,
  Reference,
  ResultsMatch,
  RosFiles,
  RunSummary,
  ScenarioSpec,
  ScenFile,
  Shown,
  Size,
  SliceRules,
  Survey,
  Unpacked,
  Window,
} from '@pkg/formicarium'
import type { PanelView, ParamValues, RunSetup } from './messages'
import type { ContourData } from './terrain'

/** What of a raster of heights is to be opened, and in how many cells; all of it as it is where nothing is said. */
export interface TerrainPart {
  crop?: Window
  size?: Size
}

/** A panel's best path, and what it was measured by. */
export interface FoundPath {
  path: [number, number][]
  /** Metres at its places; null or empty on a plane. */
  altitudes: Float64Array | null
  objective: Objective
}

/** A map as the engine takes it: its spec, and what it knows of each cell. */
export type WholeMap = [
  spec: ScenarioSpec,
  cells: Uint8Array,
  heights: Float32Array | null,
  factors: Float32Array | null,
]

/** A map as the robot feels it: where it does not fit is blocked, and what is near obstacles may cost more. */
export interface FeltCells {
  blocked: Uint8Array
  /** One a cell; null where all ground costs its length. */
  factors: Float32Array | null
}

/** What only the whole engine's worker can do, as plain functions on its side. */
export interface MapCalls {
  importMap(bytes: Uint8Array, name: string, options?: ReadOptions, image?: Uint8Array): Imported
  importScen(bytes: Uint8Array): ScenFile
  recognise(bytes: Uint8Array, name: string): Recognised
  listMatrices(bytes: Uint8Array): MatrixInfo[]
  rosImage(yaml: Uint8Array): string
  unpack(bytes: Uint8Array, name: string): Unpacked[]
  /** Its pixels, at most `most` a side. */
  showPicture(bytes: Uint8Array, most: number): Shown
  findFigure(bytes: Uint8Array): Figure
  readFigure(bytes: Uint8Array, lattice: Lattice): Figure
  figureMap(classes: Uint8Array, columns: number, name: string): Imported
  surveyTerrain(bytes: Uint8Array, name: string): Survey
  importTerrain(bytes: Uint8Array, name: string, part: TerrainPart): Imported
  /** The contour lines of heights, of which `unit` are a metre each. */
  contours(width: number, heights: Float32Array, unit: number): ContourData
  /** Whether or not the robot has room at start and goals. */
  feltMap(...map: WholeMap): FeltCells
  /** The same as `mapColours` of weighted ground, from factor 1 to 10. */
  weightColours(theme: PanelView['theme']): Uint8Array
  /** Red, green, blue: of a free cell, a blocked one, and 256 of a layer from its least value to its greatest. */
  mapColours(layer: Layer | 'none', theme: PanelView['theme']): Uint8Array
  exportMap(...args: [...map: WholeMap, format: ExportFormat]): string
  exportRos(spec: ScenarioSpec, cells: Uint8Array, image: string): RosFiles
  exportGeotiff(...map: WholeMap): Uint8Array
  /** Every format of paths, with why maps of this kind cannot give it. */
  pathFormats(spec: ScenarioSpec): PathFormatFacts[]
  writePath(map: WholeMap, found: FoundPath, format: PathFormat): PathText
  /** Throws for what is no path on this map. */
  readPath(spec: ScenarioSpec, bytes: Uint8Array): PathSteps
  /** Rules of movement by slices that suit a terrain. */
  fittingSlices(...args: [...map: WholeMap, verticalUnit: number]): SliceRules
  ablation(planner: string, preset: string | null, set: ParamValues): AblationEntry[]
  matchResults(document: string, bytes: Uint8Array, name: string): ResultsMatch
  resultsTemplate(document: string): string
  joinResults(
    document: string,
    bytes: Uint8Array,
    name: string,
    instance: string | null,
    leaveOut: string[],
  ): string
  generate(kind: Generator, width: number, height: number, seed: number, density: number): Generated
}

/** What every tools worker can do, as plain functions on its side. */
export interface ToolCalls {
  /** The core tells of its planners alone. */
  catalog(): Pick<Catalog, 'planners'>
  version(): string
  check(...map: WholeMap): Notice[]
  proposeSeed(): number
  reference(...args: [...map: WholeMap, objective: Objective]): Reference
  repeat(setup: RunSetup, iterations: number): RunSummary
}

export type ToolRequest =
  | { kind: 'init'; module: WebAssembly.Module }
  | { kind: 'call'; id: number; call: string; args: unknown[] }
export type ToolReply =
  | { id: number; ok: true; value: unknown }
  | { id: number; ok: false; error: EngineError }
