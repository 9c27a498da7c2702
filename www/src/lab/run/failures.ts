/** What could not be done, said once. */
import type { Failure } from '../store/signals'

/** The first failure of each kind: hundreds of runs of one entry may fail for the same reason. */
export function firstOfEach(all: Failure[]): Failure[] {
  const seen = new Set<string>()
  return all.filter(({ error }) => {
    const isNew = !seen.has(error.message)
    seen.add(error.message)
    return isNew
  })
}
