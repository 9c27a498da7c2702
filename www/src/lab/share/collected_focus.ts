/** Where the focus goes when the control that had it is gone with its file. */

export const COLLECTED_TITLE = 'collected-title'

export const focusCollected = () => document.getElementById(COLLECTED_TITLE)?.focus()
