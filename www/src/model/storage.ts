/** Whether the page may keep anything in the browser: no file page may, as some browsers give all files one storage. */
import { oneFile } from './one_file'

export const canKeep = (): boolean => oneFile() === null
