/** Reads the list of colours that the engine gives for a layer: of a free cell, a blocked one, then 256 of values. */

import { type Signal, signal } from '@preact/signals'
import { lateTools } from '../engine/late_tools'

type Look = Parameters<typeof lateTools.mapColours>

const known = new Map<string, Signal<Uint8Array | null>>()

/** The colours of a layer, or of the ground, in a theme; null until the engine has told. */
export function coloursOf(...look: Look): Uint8Array | null {
  const key = look.join()
  let colours = known.get(key)
  if (!colours) {
    colours = signal(null)
    known.set(key, colours)
    void ask(colours, look)
  }
  return colours.value
}

/** The map is there without its legend: what fails is asked for again the next time. */
async function ask(colours: Signal<Uint8Array | null>, look: Look): Promise<void> {
  try {
    colours.value = await lateTools.mapColours(...look)
  } catch {
    known.delete(look.join())
  }
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
