/** Drawing on the map: a press and what is dragged from it is one piece; Enter draws straight to the cell cursor. */
import type { Cell } from '../model/cell'
import {
  drawingOn,
  extendTo,
  newPiece,
  type Piece,
  redoPiece,
  startDrawing,
  takeBack,
} from './drawing'
import type { MapHandlers } from './map_input'

let piece: Piece | null = null

export function drawHandlers(panelId: number): MapHandlers {
  const on = (cell: Cell) => {
    piece ??= newPiece()
    void extendTo(cell, piece)
  }
  return {
    press(cell) {
      if (drawingOn.peek() === null) startDrawing(panelId)
      piece = newPiece()
      on(cell)
    },
    drag: on,
    release() {
      piece = null
    },
    enter: (cell) => void extendTo(cell, newPiece()),
    key: drawKey,
  }
}

/** Undo and redo are the hand's while it draws. True when the key was one of them. */
export function drawKey({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): boolean {
  const command = ctrlKey || metaKey
  if (key === 'Backspace' || (command && !shiftKey && key.toLowerCase() === 'z')) takeBack()
  else if (command && (key.toLowerCase() === 'y' || (shiftKey && key.toLowerCase() === 'z')))
    redoPiece()
  else return false
  return true
}
