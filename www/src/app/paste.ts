/** Pasting a map, a scenario, a session or a share link anywhere on the page opens it. */
import { importFiles, importText } from '../state'

/** On Linux a middle click pastes the last selection; on this page it moves the map. */
const MIDDLE_CLICK_MS = 200

export function listenForPaste(): void {
  let middleUp = Number.NEGATIVE_INFINITY
  addEventListener('pointerup', (event) => {
    if (event.button === 1) middleUp = event.timeStamp
  })
  addEventListener('paste', (event) => {
    const target = event.target as HTMLElement | null
    if (target?.closest('input, textarea, select')) return
    if (event.timeStamp - middleUp < MIDDLE_CLICK_MS) return
    const data = event.clipboardData
    if (!data) return
    if (data.files.length > 0) void importFiles(data.files)
    else if (data.getData('text').trim() !== '') void importText(data.getData('text'))
    else return
    event.preventDefault()
  })
}
