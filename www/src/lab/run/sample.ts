/** Which runs of others are done again to see whether they are honest. */

/**
 * Draws this part of all runs, from 0 to 1, by chance, and at least one of each file. `byFile`: the places of the runs of each;
 * `chance`: from 0 up to 1.
 */
export function drawSample(
  byFile: ReadonlyMap<number, readonly number[]>,
  part: number,
  chance: () => number = Math.random,
): number[] {
  const files = [...byFile.values()].map((runs) => shuffled(runs, chance))
  const firsts = files.flatMap(([first]) => (first === undefined ? [] : [first]))
  const rest = shuffled(
    files.flatMap(([, ...others]) => others),
    chance,
  )
  const wanted = Math.ceil(part * (firsts.length + rest.length))
  return [...firsts, ...rest.slice(0, Math.max(0, wanted - firsts.length))]
}

/** In an order in which each is equally likely (Fisher and Yates). */
function shuffled(runs: readonly number[], chance: () => number): number[] {
  const order = [...runs]
  for (let end = order.length - 1; end > 0; end--) {
    const at = Math.floor(chance() * (end + 1))
    const moved = order[end] as number
    order[end] = order[at] as number
    order[at] = moved
  }
  return order
}
