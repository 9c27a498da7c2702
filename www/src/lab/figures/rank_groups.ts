/** Which entries do not differ from each other. */
import type { Ranks } from '../../model/analysis'

/** From this p on, a difference may be chance. */
export const LEVEL = 0.05

interface Placed {
  entry: number
}

/** Groups of neighbours of which no two differ, without those that lie within another group or hold one entry only. */
export function groups(order: Placed[], { pairs }: Pick<Ranks, 'pairs'>): [number, number][] {
  const differ = (a: number, b: number) =>
    pairs.some(
      ({ first, second, holm }) =>
        holm < LEVEL && ((first === a && second === b) || (first === b && second === a)),
    )
  const found: [number, number][] = []
  order.forEach((_, from) => {
    let to = from
    while (to + 1 < order.length && clear(order.slice(from, to + 2), differ)) to++
    const within = found.some(([, end]) => end >= to)
    if (to > from && !within) found.push([from, to])
  })
  return found
}

const clear = (some: Placed[], differ: (a: number, b: number) => boolean) =>
  some.every((a, i) => some.slice(i + 1).every((b) => !differ(a.entry, b.entry)))
