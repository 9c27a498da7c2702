/**
 * Lets only one tab at a time run a comparison: two would do the same runs. Without the Web Locks API there is no such guard, nor
 * where the browser refuses it, as to frames in a sandbox: there nothing is stored either that another tab could run.
 */
import { canKeep } from '../../model/storage'

const nameOf = (comparison: string) => `formicarium.study.${comparison}`

const noLock = () => {}

/** Resolves to a function that unlocks it, or to null when another tab holds the lock. */
export function lockComparison(comparison: string): Promise<(() => void) | null> {
  return new Promise((resolve) => {
    const hold = (lock: Lock | null) => {
      if (!lock) return resolve(null)
      return new Promise<void>((unlock) => resolve(unlock))
    }
    request(nameOf(comparison), { ifAvailable: true }, hold).catch(() => resolve(noLock))
  })
}

export async function isLocked(comparison: string): Promise<boolean> {
  try {
    if (!canKeep()) return false
    const locks = await navigator.locks.query()
    return locks.held?.some(({ name }) => name === nameOf(comparison)) ?? false
  } catch {
    return false
  }
}

/** Resolves once no tab holds the lock; never, when `signal` ends the wait. */
export function whenUnlocked(comparison: string, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    request(nameOf(comparison), { signal }, () => resolve()).catch(() => {})
  })
}

/** Whatever is wrong with locks, it rejects. */
async function request(
  name: string,
  options: LockOptions,
  hold: (lock: Lock | null) => unknown,
): Promise<unknown> {
  if (!canKeep()) throw new Error('what nobody keeps, no other tab has')
  return navigator.locks.request(name, options, hold)
}
