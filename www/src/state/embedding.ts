/** Whether the page stands in another one (`?embed`): it shows less then, and neither reads nor writes what the browser keeps. */
import { signal } from '@preact/signals'

const query = new URLSearchParams(location.search)

/** How another page embeds this one, as its address says; null where the page stands alone. */
export const embedding = query.has('embed') ? query : null

/** Whether nobody may draw on the map. */
export const mapIsFixed = signal(false)
