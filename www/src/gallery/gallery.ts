/** The built-in scenarios. Names and notes in the reader's language live in i18n under `gallery.<id>`. */
import type { ScenarioSpec } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import { numbersOf } from '../model/cell_numbers'
import { goalAt, type Origin, type Scenario } from '../model/session'
import { plainTerrain } from '../model/terrain'
import { TWO_CORRIDORS } from './first_drawing'
import { paperMaps, type Racer } from './paper_maps'
import { paperScenario } from './paper_scenario'

export interface GalleryEntry {
  id: string
  scenario(): Promise<Scenario>
  /** Where it stands in the menu. */
  group: 'ready' | 'terrains' | 'papers'
  /** Who is to race there; absent where the map goes with any planner. */
  racers?: Racer[]
}

const drawings = () => import('./drawings')

/** What a newcomer sees: needs no engine, so it is there at once. */
export function firstScenario(): Scenario {
  return drawn('Two corridors', TWO_CORRIDORS)
}

/** The most telling first; last, the one without a path. */
const ready: Omit<GalleryEntry, 'group'>[] = [
  { id: 'two-corridors', scenario: async () => firstScenario() },
  {
    id: 'aco-20x20',
    scenario: async () => drawn('Scattered blocks, 20 × 20', (await drawings()).SCATTERED),
  },
  { id: 'engine-room', scenario: async () => drawn('Engine room', (await drawings()).ENGINE_ROOM) },
  {
    id: 'rooms',
    scenario: () => generated('Rooms', 48, 32, { generator: 'rooms', seed: 7, density: 0 }),
  },
  {
    id: 'maze',
    scenario: () => generated('Maze', 41, 27, { generator: 'maze', seed: 3, density: 0 }),
  },
  {
    id: 'random-100',
    scenario: () =>
      generated('Random, 100 × 100', 100, 100, { generator: 'random', seed: 11, density: 0.3 }),
  },
  { id: 'open-field', scenario: async () => openField() },
  { id: 'unreachable', scenario: async () => drawn('Unreachable', (await drawings()).SEALED) },
]

/** One for each way of moving on a terrain. */
const terrains: Omit<GalleryEntry, 'group'>[] = [
  {
    id: 'terrain-hills',
    scenario: async () => {
      const origin: Origin = { generator: 'hills', seed: 5, density: 0.5 }
      const made = await generated('Hills', 65, 65, origin)
      return { ...made, spec: { ...made.spec, movement: { ...made.spec.movement, moves: 16 } } }
    },
    racers: [['terrain-epf'], ['terrain-aco'], ['astar']],
  },
  {
    id: 'terrain-slices',
    scenario: async () => {
      const origin: Origin = { generator: 'fractal', seed: 2, density: 0.5 }
      return bySlices(await generated('Rough ground', 21, 21, origin))
    },
    racers: [['terrain-aco'], ['terrain-epf'], ['pso'], ['slices-exact']],
  },
]

export const gallery: GalleryEntry[] = [
  ...ready.map((entry) => ({ ...entry, group: 'ready' as const })),
  ...terrains.map((entry) => ({ ...entry, group: 'terrains' as const })),
  ...paperMaps.map(({ id, file, racers }) => ({
    id,
    scenario: () => paperScenario(file),
    group: 'papers' as const,
    racers,
  })),
]

async function bySlices(scenario: Scenario): Promise<Scenario> {
  const terrain = { vertical_unit: 1, slices: await tools.fittingSlices(scenario, 1) }
  return { ...scenario, spec: { ...scenario.spec, terrain } }
}

/** Without obstacles, every detour is the ants' doing. */
function openField(): Scenario {
  const [width, height] = [40, 25]
  return {
    spec: specOf('Open field', width, height, [4, 19], [35, 5]),
    cells: new Uint8Array(width * height),
    heights: null,
    factors: null,
    origin: null,
  }
}

function drawn(name: string, rows: readonly string[]): Scenario {
  const width = rows[0]?.length ?? 0
  const text = rows.join('')
  const at = (mark: string): [number, number] => {
    const index = text.indexOf(mark)
    return [index % width, Math.floor(index / width)]
  }
  return {
    spec: specOf(name, width, rows.length, at('S'), at('G')),
    cells: Uint8Array.from(text, (char) => (char === '#' ? 1 : 0)),
    heights: null,
    factors: null,
    origin: null,
  }
}

async function generated(
  name: string,
  width: number,
  height: number,
  origin: Origin,
): Promise<Scenario> {
  const { generator, seed, density } = origin
  const made = await tools.generate(generator, width, height, seed, density)
  const heights = numbersOf(made.heights)
  const spec = specOf(name, width, height, made.start, made.goal)
  const { resolution, cells } = made
  const terrain = heights && { terrain: plainTerrain() }
  return { spec: { ...spec, resolution, ...terrain }, cells, heights, factors: null, origin }
}

function specOf(
  name: string,
  width: number,
  height: number,
  start: [number, number],
  goal: [number, number],
): ScenarioSpec {
  return {
    name,
    width,
    height,
    resolution: 1,
    movement: { moves: 8, corner_rule: 'both-free' },
    start,
    goals: [goalAt(goal, 'goal')],
    vehicle: { speed: 1, seconds_per_turn: 1 },
  }
}
