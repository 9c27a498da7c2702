/**
 * Tells ants apart from one step to the next. The engine lists the living in index order and leaves out the dead, so following
 * the list in order and skipping whoever is too far away finds the same ant again; that gives each a heading and a place of its
 * own within a shared cell.
 */

export interface Ant {
  /** Stays with the ant for its life. */
  id: number
  fromX: number
  fromY: number
  x: number
  y: number
  /** Radians. */
  heading: number
}

export class Crowd {
  private ants: Ant[] = []
  private nextId = 0

  get size(): number {
    return this.ants.length
  }

  [Symbol.iterator](): Iterator<Ant> {
    return this.ants[Symbol.iterator]()
  }

  /** Without those that have arrived: they would pile up on the goal and hide it. */
  underWay(goals: { at: [number, number] }[]): Ant[] {
    const arrived = ({ x, y, fromX, fromY }: Ant) =>
      x === fromX && y === fromY && goals.some(({ at }) => at[0] === x && at[1] === y)
    return this.ants.filter((ant) => !arrived(ant))
  }

  clear(): void {
    this.ants = []
    this.nextId = 0
  }

  /** `positions`: x0, y0, x1, y1, …; `single`: after one move, when an ant can only have gone to a neighbouring cell. */
  update(positions: Uint32Array, single: boolean): void {
    const before = this.ants
    const sameCount = before.length * 2 === positions.length
    let next = 0
    const find = (x: number, y: number): Ant | undefined => {
      if (!single) return sameCount ? before[next++] : undefined
      while (next < before.length && !near(before[next], x, y)) next++
      return before[next++]
    }
    this.ants = []
    for (let i = 0; i + 1 < positions.length; i += 2) {
      const x = positions[i] ?? 0
      const y = positions[i + 1] ?? 0
      const old = find(x, y)
      this.ants.push(old ? moved(old, x, y, single) : this.hatched(x, y))
    }
  }

  private hatched(x: number, y: number): Ant {
    const id = this.nextId++
    return { id, fromX: x, fromY: y, x, y, heading: (id * 2.4) % (2 * Math.PI) }
  }
}

function moved(ant: Ant, x: number, y: number, single: boolean): Ant {
  const still = x === ant.x && y === ant.y
  const heading = still ? ant.heading : Math.atan2(y - ant.y, x - ant.x)
  return { id: ant.id, fromX: single ? ant.x : x, fromY: single ? ant.y : y, x, y, heading }
}

function near(ant: Ant | undefined, x: number, y: number): boolean {
  return ant !== undefined && Math.abs(ant.x - x) <= 1 && Math.abs(ant.y - y) <= 1
}
