/** Leaving the page asks where something would be lost: what the browser could not store. */
const unsaved = new Set<string>()

const ask = (event: BeforeUnloadEvent) => event.preventDefault()

/** `what` is lost with the page, or no longer. Without anything to lose there is no listener, so that browsers may keep the page for Back. */
export function askBeforeLeaving(what: string, isLost: boolean): void {
  if (isLost) unsaved.add(what)
  else unsaved.delete(what)
  if (unsaved.size > 0) addEventListener('beforeunload', ask)
  else removeEventListener('beforeunload', ask)
}
