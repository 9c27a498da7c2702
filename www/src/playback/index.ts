/** Looking back at runs, into cells and at differences: one part of the page, fetched with the first look. */
import '../styles/playback.css'
import { addPlaybackWords } from '../i18n/playback'
import { CompareButton } from './compare_button'
import { DifferencePanel } from './difference_panel'
import { Inspector } from './inspector'
import { PastChip, Scrubber } from './scrubber'

export { MoveArrows } from './move_arrows'
export { MoveTable, percent } from './move_table'
export { byDirection, type Move } from './moves'

const ready = () => addPlaybackWords()

export const fetchScrubber = () => ready().then(() => Scrubber)
export const fetchPastChip = () => ready().then(() => PastChip)
export const fetchInspector = () => ready().then(() => Inspector)
export const fetchDifference = () => ready().then(() => DifferencePanel)
export const fetchCompareButton = () => ready().then(() => CompareButton)
