/**
 * Begins what every visit waits for, before the rest of the page has been read: the core of the engine is fetched and compiled, and
 * workers start, while the page's own thread reads on. To be imported first.
 */
import { modules } from './load'
import { startAhead } from './new_worker'

/** The tools' own, and one for each panel of a first visit. */
const WORKERS = 3

startAhead(WORKERS)
// Whoever needs it asks again, and hears why it did not come.
modules.core().catch(() => {})
