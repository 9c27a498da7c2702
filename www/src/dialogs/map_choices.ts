/** What the reader chooses about a map that leaves a choice, and how the engine is told. */
import type { CostRule, ReadOptions } from '@pkg/formicarium'
import { limits } from '../model/facts'
import { type Crop, cropFits, isWhole } from '../model/raster_part'
import { PLAIN } from '../model/weights'
import type { MapFile } from '../state'

export interface MapChoices {
  /** Of a text with several matrices, from 1. */
  matrix: number
  /** Of a picture: grays below it are dark; null: chosen by the engine. */
  threshold: number | null
  lightIsBlocked: boolean
  metresPerCell: number
  /** Null: all of it. */
  crop: Crop | null
  /** Most cells a side; null: as many as there are, or as a map can have. */
  cells: number | null
  /** Of a robot's map. */
  unknown: 'blocked' | 'free'
  /** Whether all around what it knows is left out. */
  knownOnly: boolean
  /** By which rule its values are costs; null: thresholds tell free cells from walls. */
  costs: CostRule | null
  /** Of a rule that has one. */
  multiplier: number
  /** What a way through swamp costs, in lengths. */
  swampFactor: number
}

export const USUAL: MapChoices = {
  matrix: 1,
  threshold: 128,
  lightIsBlocked: false,
  metresPerCell: 1,
  crop: null,
  cells: null,
  unknown: 'blocked',
  knownOnly: false,
  costs: null,
  multiplier: 2,
  swampFactor: PLAIN,
}

export const isPicture = ({ kind }: MapFile) => kind === 'picture'
/** Maps with free, occupied and unknown cells, a size in metres and a place in the world. */
export const isRobots = ({ kind }: MapFile) => kind === 'ros-map' || kind === 'occupancy-grid'

export function optionsOf(file: MapFile, choices: MapChoices): ReadOptions {
  const { matrix, cells, unknown, costs: rule, multiplier, swampFactor } = choices
  if (isRobots(file))
    return {
      unknown,
      ...(rule && { costs: { rule, multiplier } }),
      ...(cells !== null && { cells }),
    }
  // At 1 it is as free as any other cell, and the map needs no factors.
  if (file.swamp) return swampFactor === PLAIN ? {} : { swamp_factor: swampFactor }
  if (!isPicture(file)) return file.matrices.length > 1 ? { matrix } : {}
  const { threshold, lightIsBlocked, metresPerCell, crop } = choices
  return {
    picture: {
      // Null: none is given, and one is chosen. Left out it would be 128.
      threshold,
      light_is_blocked: lightIsBlocked,
      metres_per_cell: metresPerCell,
      ...(crop && { crop }),
      ...(cells !== null && { cells }),
    },
  }
}

export interface Sides {
  width: number
  height: number
}

/** The longer side of what is read, in cells or pixels, as far as a map can have them. */
export const longest = ({ width, height }: Sides) =>
  Math.min(limits.max_side, Math.max(width, height))

/** Whether everything that was typed can be used; `whole`: the size of the picture or map, once it is known. */
export function choicesFit({ crop, cells, metresPerCell }: MapChoices, whole: Sides | null) {
  const most = longest(crop ?? whole ?? { width: limits.max_side, height: 1 })
  return {
    crop: crop === null || whole === null || cropFits(crop, whole),
    cells: cells === null || (Number.isInteger(cells) && cells >= 1 && cells <= most),
    metres: metresPerCell > 0 && metresPerCell <= 1e6,
  }
}

/** A part instead of the whole, or another part; the number of cells stays within it. */
export function cropped(choices: MapChoices, crop: Crop, whole: Sides): MapChoices {
  const { cells } = choices
  return {
    ...choices,
    crop: isWhole(crop, whole) && crop.x === 0 && crop.y === 0 ? null : crop,
    cells: cells === null ? null : Math.min(cells, longest(crop)),
  }
}
