/** What a tab remembers through a reload: the ids of its open comparison and of its draft. */
import { embedding } from '../../state/embedding'

/** The open comparison. */
export const COMPARISON_IN_TAB = 'formicarium.study'

/** Private windows may refuse storage. */
export function rememberInTab(key: string, id: string | null): void {
  if (embedding) return
  try {
    if (id === null) sessionStorage.removeItem(key)
    else sessionStorage.setItem(key, id)
  } catch {}
}

export function recallInTab(key: string): string | null {
  if (embedding) return null
  try {
    return sessionStorage.getItem(key)
  } catch {
    return null
  }
}
