/**
 * Colours by slot: Okabe and Ito's set, darkened where it must stand on white, so that neighbours
 * stay apart for colour-blind readers. The same values in both themes keep screenshots comparable.
 */
export const COLOURS = ['#d5580a', '#2f7ec7', '#0b8f69', '#b0508c', '#8a6d00', '#5b5fc7'] as const

/** Of what has no slot: the path by hand. */
const HAND_COLOUR = '#d1305a'

export function slotColour(slot: number): string {
  return COLOURS[slot % COLOURS.length] ?? HAND_COLOUR
}
