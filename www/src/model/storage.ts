/** Whether the page may keep anything in the browser: no page of one file may, as some browsers give all files one storage. */
import type {} from './one_file'

export const canKeep = (): boolean => !globalThis.formicariumFile
