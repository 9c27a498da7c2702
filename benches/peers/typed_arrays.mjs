// Ant System as a careful JavaScript program would have it: typed arrays, nothing allocated in the walk, weights kept by cell and
// recomputed where a trail changed, evaporation as one factor. The rules are the engine's defaults (src/aco/classics/ant_system.rs): a
// random proportional choice, η by detour, a tabu list, steps back out of dead ends, a limit of moves, Q / length on every step of every
// ant that arrived. Only the random stream is another, so its runs are others too.

const BETA = 5
const RHO = 0.5
const MOVE_LIMIT = 4
const FLOOR = 1e-30
const SWEEP_BELOW = 1e-9

/** Eight directions, clockwise from the right; the opposite one is four further. */
const DX = [1, 1, 0, -1, -1, -1, 0, 1]
const DY = [0, 1, 1, 1, 0, -1, -1, -1]

/** The length on an open map. */
function octile(dx, dy) {
  const [a, b] = [Math.abs(dx), Math.abs(dy)]
  return Math.max(a, b) + (Math.SQRT2 - 1) * Math.min(a, b)
}

/** xorshift128, as numbers from 0 to 1. */
function stream(seed) {
  let [x, y, z, w] = [seed | 0 || 1, 362436069, 521288629, 88675123]
  const next = () => {
    const t = x ^ (x << 11)
    x = y
    y = z
    z = w
    w = w ^ (w >>> 19) ^ t ^ (t >>> 8)
    return (w >>> 8) / 2 ** 24
  }
  for (let i = 0; i < 16; i++) next()
  return next
}

export class AntSystem {
  constructor({ spec, cells }, ants, seed) {
    const { width, height, start } = spec
    const goal = spec.goals[0].at
    Object.assign(this, { width, height, ants, random: stream(seed) })
    this.start = start[1] * width + start[0]
    this.goal = goal[1] * width + goal[0]
    this.offsets = Int32Array.from(DX, (dx, d) => DY[d] * width + dx)
    this.odds = new Float64Array(8)
    this.limit = MOVE_LIMIT * (width + height)
    const size = width * height
    this.trails = new Float32Array(8 * size).fill(1)
    this.scale = 1
    this.weights = this.visibility(cells, goal)
    this.seen = this.weights.slice()
    this.dirty = new Uint8Array(size)
    this.touched = []
    /** Which walk was last in a cell. */
    this.visited = new Int32Array(size)
    this.walks = 0
    this.ways = Array.from({ length: ants }, () => new Uint8Array(this.limit))
    this.steps = new Int32Array(ants)
    this.moves = 0
    this.best = { length: Number.POSITIVE_INFINITY, way: new Uint8Array(0) }
  }

  /** (η / η_max)^β of every step; 0 of those that are not allowed. */
  visibility(cells, goal) {
    const { width, height } = this
    const seen = new Float32Array(8 * width * height)
    const free = (x, y) => x >= 0 && x < width && y >= 0 && y < height && cells[y * width + x] === 0
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        if (!free(x, y)) continue
        const eta = DX.map((dx, d) => {
          const dy = DY[d]
          const allowed = free(x + dx, y + dy) && free(x + dx, y) && free(x, y + dy)
          if (!allowed) return 0
          const before = octile(goal[0] - x, goal[1] - y)
          const after = octile(goal[0] - x - dx, goal[1] - y - dy)
          return 1 / (1 + Math.max(0, Math.hypot(dx, dy) + after - before))
        })
        const largest = Math.max(...eta)
        for (let d = 0; d < 8; d++) {
          if (eta[d] > 0)
            seen[8 * (y * width + x) + d] = Math.max((eta[d] / largest) ** BETA, FLOOR)
        }
      }
    }
    return seen
  }

  iterate() {
    const lengths = this.ways.map((_, ant) => this.walk(ant))
    this.evaporate()
    for (let ant = 0; ant < this.ants; ant++) {
      if (lengths[ant] > 0) this.deposit(ant, lengths[ant])
    }
    for (const cell of this.touched) this.weigh(cell)
    this.touched.length = 0
  }

  /** One ant; the answer is the length of its way, or 0 when it did not arrive. */
  walk(ant) {
    const { weights, visited, offsets, odds, goal, limit, random } = this
    const way = this.ways[ant]
    const walk = ++this.walks
    let at = this.start
    let steps = 0
    let moves = 0
    visited[at] = walk
    while (at !== goal && moves < limit) {
      moves++
      const row = 8 * at
      let total = 0
      for (let d = 0; d < 8; d++) {
        const weight = weights[row + d]
        const open = weight > 0 && visited[at + offsets[d]] !== walk
        odds[d] = open ? weight : 0
        total += odds[d]
      }
      if (total > 0) {
        const wanted = random() * total
        let chosen = 0
        let sum = odds[0]
        while (sum <= wanted) sum += odds[++chosen]
        way[steps++] = chosen
        at += offsets[chosen]
        visited[at] = walk
      } else if (steps > 0) {
        at -= offsets[way[--steps]]
      } else break
    }
    this.moves += moves
    this.steps[ant] = steps
    return at === goal ? this.measure(way, steps) : 0
  }

  measure(way, steps) {
    let diagonal = 0
    for (let i = 0; i < steps; i++) diagonal += way[i] & 1
    const length = steps - diagonal + Math.SQRT2 * diagonal
    if (length < this.best.length) this.best = { length, way: way.slice(0, steps) }
    return length
  }

  evaporate() {
    this.scale *= 1 - RHO
    if (this.scale > SWEEP_BELOW) return
    for (let i = 0; i < this.trails.length; i++) {
      this.trails[i] = Math.max(this.trails[i] * this.scale, FLOOR)
    }
    this.scale = 1
  }

  deposit(ant, length) {
    const amount = 1 / length / this.scale
    const way = this.ways[ant]
    let at = this.start
    for (let i = 0; i < this.steps[ant]; i++) {
      this.trails[8 * at + way[i]] += amount
      if (this.dirty[at] === 0) {
        this.dirty[at] = 1
        this.touched.push(at)
      }
      at += this.offsets[way[i]]
    }
  }

  /** τ / τ_max · (η / η_max)^β of a cell's steps. */
  weigh(cell) {
    const { trails, seen, weights } = this
    let largest = 0
    for (let i = 8 * cell; i < 8 * cell + 8; i++) {
      if (seen[i] > 0 && trails[i] > largest) largest = trails[i]
    }
    for (let i = 8 * cell; i < 8 * cell + 8; i++) {
      if (seen[i] > 0) weights[i] = Math.max((trails[i] / largest) * seen[i], FLOOR)
    }
    this.dirty[cell] = 0
  }

  /** Cells of the best way so far, as [x, y]. */
  path() {
    let at = this.start
    const cells = [at, ...Array.from(this.best.way, (d) => (at += this.offsets[d]))]
    return cells.map((cell) => [cell % this.width, Math.floor(cell / this.width)])
  }
}

/** One iteration of it with its tables, then so many more. */
export function walk(map, { iterations, params }) {
  return (seed) => {
    const begin = performance.now()
    const colony = new AntSystem(map, params.ants, seed)
    colony.iterate()
    const first = (performance.now() - begin) / 1000
    const before = colony.moves
    const next = performance.now()
    for (let i = 0; i < iterations; i++) colony.iterate()
    const seconds = (performance.now() - next) / 1000
    return { first, seconds, moves: colony.moves - before, path: colony.path() }
  }
}
