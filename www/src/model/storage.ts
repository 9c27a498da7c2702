/**
 * Whether the page may keep anything in the browser: no page of one file may, as some browsers give all files one storage, and none that
 * stands in another page, which must not come by what its reader keeps.
 */
import type {} from './one_file'

const isEmbedded = new URLSearchParams(globalThis.location?.search).has('embed')

export const canKeep = (): boolean => !globalThis.formicariumFile && !isEmbedded
