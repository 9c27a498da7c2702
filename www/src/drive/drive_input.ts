/** The map under pointer and keys while something that moves is edited; otherwise it is used as ever. */

import type { MapHandlers } from '../lesson/map_input'
import type { Cell } from '../model/cell'
import { lineCells, sameCell } from '../model/edit'
import { full } from '../model/moving'
import { mapIsFixed } from '../state/embedding'
import { brushWalls, edited, extendTrack, movingNow } from './moving'

let gesture = 0
let last: Cell | null = null
/** The press began on a cell of the walls in hand: it takes cells out. */
let leaves = false

/** On every panel, as they all show the same map: what is in hand is no wall anywhere. */
export function driveHandlers(): MapHandlers | null {
  const hand = edited.peek()
  if (!hand || mapIsFixed.peek()) return null
  return hand.list === 'tracks' ? TRACK : WALLS
}

const newGesture = () => {
  gesture = Math.random()
}

const TRACK: MapHandlers = {
  press(cell) {
    newGesture()
    extendTrack(cell, gesture)
  },
  drag: (cell) => extendTrack(cell, gesture),
  enter(cell) {
    newGesture()
    extendTrack(cell, gesture)
  },
}

const WALLS: MapHandlers = {
  press: beginBrush,
  drag(cell) {
    brushWalls(last ? lineCells(last, cell) : [cell], leaves, gesture)
    last = cell
  },
  enter: beginBrush,
}

function beginBrush(cell: Cell): void {
  newGesture()
  last = cell
  leaves = isInHand(cell)
  brushWalls([cell], leaves, gesture)
}

function isInHand(cell: Cell): boolean {
  const change = movingNow().changes[edited.peek()?.index ?? -1]
  if (!change) return false
  const { blocked, freed } = full(change)
  return [...blocked, ...freed].some((each) => sameCell(each, cell))
}
