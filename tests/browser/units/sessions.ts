/** Sessions to encode, without the engine. */
import type { Origin, Session } from '../../../www/src/model/session'
import type { Ground } from '../../../www/src/share/codec'

export function sessionOf(width: number, height: number, cells?: Uint8Array): Session {
  return {
    scenario: {
      spec: {
        name: 'Harbour “Süd” 港',
        width,
        height,
        resolution: 0.5,
        movement: { moves: 8, corner_rule: 'one-free' },
        start: [0, 0],
        goals: [{ at: [width - 1, height - 1], name: 'berth', area: 2, strength: 0.5, danger: 1 }],
        vehicle: { speed: 1.5, seconds_per_turn: 0.25 },
      },
      cells: cells ?? randomCells(width, height, 0.3),
      heights: null,
      factors: null,
      origin: null,
    },
    panels: [
      {
        planner: 'ant-system',
        preset: 'fire',
        params: { ants: 50, rho: 0.3, dead_end: 'retreat', elitist: true },
        label: null,
        result: {
          iterations: 42,
          status: 'running',
          length: 38.970562748477136,
          digest: '0123456789abcdef',
        },
      },
      { planner: 'astar', preset: null, params: {}, label: null, result: null },
    ],
    seed: 4_294_967_295,
    sync: 'iterations',
    speed: 4,
    layer: 'visits',
    title: '',
    note: '',
    look: null,
    inspected: null,
  }
}

/** A fixed, cheap sequence: the tests need noise, not statistics. */
export function randomCells(width: number, height: number, density: number): Uint8Array {
  let state = 12345
  return Uint8Array.from({ length: width * height }, () => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0
    return state / 2 ** 32 < density ? 1 : 0
  })
}

/** Stands in for the engine's generators: deterministic in its arguments, which is all the codec relies on. */
export async function generate(origin: Origin, width: number, height: number): Promise<Ground> {
  const heights = origin.generator === 'hills' ? rolling(width, height, 400) : null
  const density = heights ? 0 : origin.density
  return { cells: randomCells(width, height, density), heights, factors: null }
}

/** A terrain with heights of one's own; blocked where they are unknown. */
export function terrainOf(width: number, height: number, heights: Float32Array): Session {
  const session = sessionOf(
    width,
    height,
    Uint8Array.from(heights, (h) => (Number.isNaN(h) ? 1 : 0)),
  )
  session.scenario.heights = heights
  session.scenario.spec.terrain = { vertical_unit: 1, max_slope: 90 }
  return session
}

/** Round hills of so many metres, as f32 are. */
export function rolling(width: number, height: number, metres: number): Float32Array {
  return Float32Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)]
    return (metres * (2 + Math.sin(x / 7) + Math.cos(y / 9))) / 4
  })
}
