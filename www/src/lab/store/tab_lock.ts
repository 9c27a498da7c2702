/** An experiment is run by one tab at a time: two would do the same runs. Browsers without locks have to do without. */

const nameOf = (study: string) => `formicarium.study.${study}`

/** Gives back how to let go, or null when another tab has it. */
export function takeAlone(study: string): Promise<(() => void) | null> {
  if (!navigator.locks) return Promise.resolve(() => {})
  return new Promise((resolve, reject) => {
    const hold = (lock: Lock | null) => {
      if (!lock) return resolve(null)
      return new Promise<void>((letGo) => resolve(letGo))
    }
    navigator.locks.request(nameOf(study), { ifAvailable: true }, hold).catch(reject)
  })
}

export async function isTaken(study: string): Promise<boolean> {
  const locks = await navigator.locks?.query()
  return locks?.held?.some(({ name }) => name === nameOf(study)) ?? false
}

/** Resolves once no tab has it; never, when `signal` ends the wait. */
export function whenFree(study: string, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    navigator.locks?.request(nameOf(study), { signal }, () => resolve()).catch(() => {})
  })
}
