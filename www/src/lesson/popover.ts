/** Where a box opens: below its button, above it where that leaves too little room, never beyond the screen. */
const MARGIN = 8

export function placeBeside(button: HTMLElement, box: HTMLElement): void {
  const { left, top, bottom } = button.getBoundingClientRect()
  const { style, offsetWidth, offsetHeight } = box
  const below = bottom + 6
  const fits = below + offsetHeight + MARGIN <= innerHeight
  style.top = `${Math.max(MARGIN, fits ? below : Math.min(top - 6, innerHeight - MARGIN) - offsetHeight)}px`
  style.maxHeight = `${innerHeight - 2 * MARGIN}px`
  style.left = `${Math.max(MARGIN, Math.min(left, innerWidth - offsetWidth - MARGIN))}px`
}
