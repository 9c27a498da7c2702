/** A rectangle of a map's cells, taken up to be put down elsewhere. Pure, as all edits are. */
import type { Cell } from './cell'
import { takenCells } from './goals'
import type { Scenario } from './session'
import type { Area, Sides } from './spans'
import { placeAfter, sidesAfter, type Turn } from './turn'
import { PLAIN, plainOrNone } from './weights'

/** Row by row: 0 free, 1 wall, 2 for what is not known there. */
export interface Block extends Sides {
  cells: Uint8Array
  /** What the ground of each costs; null where all of it is plain. */
  factors: Float32Array | null
}

const UNKNOWN = 2

export function blockOf({ spec, cells, heights, factors }: Scenario, area: Area): Block {
  const taken = new Uint8Array(area.width * area.height)
  const weights = factors && new Float32Array(taken.length).fill(PLAIN)
  for (let i = 0; i < taken.length; i++) {
    const [x, y] = [area.x + (i % area.width), area.y + Math.floor(i / area.width)]
    const cell = y * spec.width + x
    const known = heights === null || Number.isFinite(heights[cell])
    taken[i] = known ? (cells[cell] ?? UNKNOWN) : UNKNOWN
    if (weights) weights[i] = factors?.[cell] ?? PLAIN
  }
  return { width: area.width, height: area.height, cells: taken, factors: weights }
}

/** A block as large as another with all its cells free, on plain ground. */
export const freeBlock = ({ width, height }: Sides): Block => ({
  width,
  height,
  cells: new Uint8Array(width * height),
  factors: null,
})

export interface Laid {
  map: Scenario
  /** How many walls were left out, because start or goals are there. */
  keptFree: number
}

/**
 * Lays a block over a map, its upper left cell at `at`. Start and goals stay free, cells without data and what lies outside stay as
 * they are; what the ground costs comes with the block. The same object comes back when nothing changes.
 */
export function layBlock(scenario: Scenario, block: Block, [left, top]: Cell): Laid {
  const { spec, heights, cells: before } = scenario
  const ground = heights ? null : new Ground(scenario, block)
  const ends = new Set(takenCells(spec).map(([x, y]) => y * spec.width + x))
  let cells: Uint8Array | null = null
  let keptFree = 0
  for (const [i, value] of block.cells.entries()) {
    const [x, y] = [left + (i % block.width), top + Math.floor(i / block.width)]
    if (value === UNKNOWN || x < 0 || y < 0 || x >= spec.width || y >= spec.height) continue
    const cell = y * spec.width + x
    if (heights && !Number.isFinite(heights[cell])) continue
    ground?.lay(i, cell)
    if (value === 1 && ends.has(cell)) keptFree++
    else if (before[cell] !== value) {
      cells ??= before.slice()
      cells[cell] = value
    }
  }
  const factors = ground ? ground.after() : scenario.factors
  const isSame = cells === null && factors === scenario.factors
  return {
    map: isSame ? scenario : { ...scenario, cells: cells ?? before.slice(), factors },
    keptFree,
  }
}

/** The factors of a map on which a block is being laid: made anew with the first that changes. */
class Ground {
  private made: Float32Array | null = null

  constructor(
    private readonly map: Scenario,
    private readonly block: Block,
  ) {}

  lay(from: number, to: number): void {
    const factor = this.block.factors?.[from] ?? PLAIN
    if ((this.map.factors?.[to] ?? PLAIN) === factor) return
    this.made ??= this.map.factors?.slice() ?? new Float32Array(this.map.cells.length).fill(PLAIN)
    this.made[to] = factor
  }

  after(): Float32Array | null {
    return this.made ? plainOrNone(this.made) : this.map.factors
  }
}

export function turnBlock(block: Block, turn: Turn): Block {
  const sides = sidesAfter(block, turn)
  const cells = new Uint8Array(block.cells.length)
  const factors = block.factors?.slice() ?? null
  for (const [i, value] of block.cells.entries()) {
    const at = placeAfter([i % block.width, Math.floor(i / block.width)], block, turn)
    cells[at[1] * sides.width + at[0]] = value
    if (factors) factors[at[1] * sides.width + at[0]] = block.factors?.[i] ?? PLAIN
  }
  return { ...sides, cells, factors }
}
