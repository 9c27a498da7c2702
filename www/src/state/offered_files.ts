/** Files that wait for the reader to say how they are meant; while there is one, its dialog is open. */
import type { Kind, MatrixInfo, ScenLine, Survey } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import type { Scenario } from '../model/session'

/** A file by its name and what it holds. */
export interface NamedBytes {
  name: string
  bytes: Uint8Array
}

export interface ScenChoice {
  fileName: string
  lines: ScenLine[]
}

/** Where a map that was opened goes instead of the race. */
export type Taker = (opened: Scenario) => void

export interface TerrainFile extends NamedBytes {
  /** Null: to the race. */
  take: Taker | null
  survey: Survey
}

/** A file with what it was recognised as. */
export interface FoundFile extends NamedBytes {
  kind: Kind
  /** Whether it is a raster of heights. */
  raster: boolean
  /** Whether a map can be made of it. */
  map: boolean
  /** Whether nothing else could be meant. */
  certain: boolean
  /** By what it was told, in English. */
  why: string
}

/** A map and what came with it. */
export interface MapFile extends FoundFile {
  /** The matrices of a text that holds several. */
  matrices: MatrixInfo[]
  /** Whether it has swamp, which may be given a factor. */
  swamp: boolean
  /** Of a ROS map the picture that it names. */
  image: NamedBytes | null
  /** The name of that picture in the description; empty for any other map. */
  names: string
  /** The same, as long as the picture is missing. */
  needs: string | null
  /** Scenarios for it. */
  scens: NamedBytes[]
  /** Null: to the race. */
  take: Taker | null
}

/** Several maps that came together. */
export interface MapChoice {
  files: FoundFile[]
  /** What else came: pictures and scenarios that belong to one of them. */
  others: FoundFile[]
}

/** Scenarios of a .scen file: one is to be chosen. */
export const scenChoice = signal<ScenChoice | null>(null)
/** A raster: which part of it is to be opened? */
export const terrainFile = signal<TerrainFile | null>(null)
/** A map that leaves a choice. */
export const mapFile = signal<MapFile | null>(null)
export const mapChoice = signal<MapChoice | null>(null)
