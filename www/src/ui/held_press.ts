/**
 * A press that begins on a button counts, also where the page moves the button away meanwhile: the press takes the focus from a field,
 * the field tells what was typed, and a hint or an error comes or goes above the button. A browser clicks only what lies under both ends
 * of a press.
 */

interface Press {
  pointer: number
  button: HTMLButtonElement
  /** Where the button was when the press began. */
  box: DOMRect
}

let press: Press | null = null
let listens = false

/** From now on; asked for by the parts that have fields above buttons. */
export function holdPresses(): void {
  if (listens) return
  listens = true
  document.addEventListener('pointerdown', begin, true)
  document.addEventListener('pointerup', end, true)
  document.addEventListener('pointercancel', forget, true)
}

function begin({ target, button, isPrimary, pointerId }: PointerEvent): void {
  const pressed = target instanceof Element ? target.closest('button') : null
  press =
    pressed && button === 0 && isPrimary
      ? { pointer: pointerId, button: pressed, box: pressed.getBoundingClientRect() }
      : null
}

function end(event: PointerEvent): void {
  const now = press
  press = null
  if (!now || now.pointer !== event.pointerId || !now.button.isConnected) return
  const { button, box } = now
  const left = button.getBoundingClientRect()
  const stayed = left.x === box.x && left.y === box.y
  if (stayed || !isIn(box, event) || isIn(left, event)) return
  button.click()
}

function forget(): void {
  press = null
}

/** Whoever draws the pointer off a button takes the press back. */
const isIn = ({ left, right, top, bottom }: DOMRect, { clientX, clientY }: PointerEvent) =>
  clientX >= left && clientX <= right && clientY >= top && clientY <= bottom
