/** Pasting a map, a scenario, an experiment or a share link anywhere on the page opens it. */
import { importFiles, importText } from '../state'

export function listenForPaste(): void {
  addEventListener('paste', (event) => {
    const target = event.target as HTMLElement | null
    if (target?.closest('input, textarea, select')) return
    const data = event.clipboardData
    if (!data) return
    if (data.files.length > 0) void importFiles(data.files)
    else if (data.getData('text').trim() !== '') void importText(data.getData('text'))
    else return
    event.preventDefault()
  })
}
