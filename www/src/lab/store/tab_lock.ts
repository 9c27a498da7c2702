/** Lets only one tab at a time run a comparison: two would do the same runs. Without the Web Locks API there is no such guard. */
import { canKeep } from '../../model/storage'

/** What nobody keeps, no other tab has. */
const locks = () => (canKeep() ? navigator.locks : undefined)

const nameOf = (comparison: string) => `formicarium.study.${comparison}`

/** Resolves to a function that unlocks it, or to null when another tab holds the lock. */
export function lockComparison(comparison: string): Promise<(() => void) | null> {
  const all = locks()
  if (!all) return Promise.resolve(() => {})
  return new Promise((resolve, reject) => {
    const hold = (lock: Lock | null) => {
      if (!lock) return resolve(null)
      return new Promise<void>((unlock) => resolve(unlock))
    }
    all.request(nameOf(comparison), { ifAvailable: true }, hold).catch(reject)
  })
}

export async function isLocked(comparison: string): Promise<boolean> {
  const now = await locks()?.query()
  return now?.held?.some(({ name }) => name === nameOf(comparison)) ?? false
}

/** Resolves once no tab holds the lock; never, when `signal` ends the wait. */
export function whenUnlocked(comparison: string, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    locks()
      ?.request(nameOf(comparison), { signal }, () => resolve())
      .catch(() => {})
  })
}
