/** Sessions that scripts make. */
import type { Wordless } from '../share/session_words'
import { loadSession } from './sessions'

/** One older than terrains, titles or labels has none of them. It does not play by itself. */
export async function openGiven(given: Wordless): Promise<boolean> {
  const { withWords } = await import('../share/link')
  const heights = given.scenario.heights ?? null
  loadSession(withWords({ ...given, scenario: { ...given.scenario, heights } }))
  return true
}
