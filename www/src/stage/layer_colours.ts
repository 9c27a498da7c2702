/** Reads the list of colours that the engine gives for a layer: of a free cell, a blocked one, then 256 of values. */

import { type Signal, signal } from '@preact/signals'
import { lateTools } from '../engine/late_tools'

type Look = Parameters<typeof lateTools.mapColours>

const known = new Map<string, Signal<Uint8Array | null>>()

/** The colours of a layer, or of the ground, in a theme; null until the engine has told. */
export const coloursOf = (...look: Look): Uint8Array | null =>
  toldOnce(look.join(), () => lateTools.mapColours(...look))

/** Of weighted ground, in the same order. */
export const weightColoursOf = (theme: Look[1]): Uint8Array | null =>
  toldOnce(`weights ${theme}`, () => lateTools.weightColours(theme))

/** The map is there without its legend: what fails is asked for again the next time. */
function toldOnce(key: string, ask: () => Promise<Uint8Array>): Uint8Array | null {
  const before = known.get(key)
  if (before) return before.value
  const colours: Signal<Uint8Array | null> = signal(null)
  known.set(key, colours)
  ask().then(
    (told) => {
      colours.value = told
    },
    () => known.delete(key),
  )
  return colours.value
}

/** Places in the list. */
export const FREE = 0
export const BLOCKED = 1
export const LEAST = 2
export const MOST = 257
/** Stops of a gradient; they lie closer at the low end, where colours change fastest. */
const STOPS = 24

export function colourAt(colours: Uint8Array, place: number): string {
  const hex = [...colours.subarray(3 * place, 3 * place + 3)].map((part) =>
    part.toString(16).padStart(2, '0'),
  )
  return `#${hex.join('')}`
}

export interface Stop {
  /** From 0, the least value, to 1. */
  at: number
  colour: string
}

/** Colours from the least value to the greatest, evenly by value. */
export function stopsOf(colours: Uint8Array): Stop[] {
  return Array.from({ length: STOPS + 1 }, (_, i) => {
    const place = Math.round((MOST - LEAST) * (i / STOPS) ** 2)
    return { at: place / (MOST - LEAST), colour: colourAt(colours, LEAST + place) }
  })
}

export function gradient(colours: Uint8Array): string {
  const stops = stopsOf(colours).map(({ at, colour }) => `${colour} ${(100 * at).toFixed(2)}%`)
  return `linear-gradient(to right, ${stops.join(', ')})`
}
