/** How long things are on the maps of a frame or step: a line of a round length beside the first caption, where it hides nothing. */
import { roundLength } from '../model/metres'
import { barScale, barWords } from '../words/metres'
import type { FrameLayout } from './frame_layout'

/** Of a map's width at most. */
const LONGEST_SHARE = 0.18
/** Letters of a caption that is wide enough for a bar beside what has been reached. */
const LEAST_LETTERS = 18

export interface FrameBar {
  /** Of the line. */
  pixels: number
  words: string
}

/** Null on maps without a scale, and where there is no room. `columns`: cells of the map's width. */
export function barOf({ panels, letter }: FrameLayout, columns: number): FrameBar | null {
  const counted = barScale.peek()
  const [first] = panels
  if (counted === null || !first || first.caption.width < LEAST_LETTERS * letter) return null
  const perPixel = (counted * columns) / first.map.width
  const length = roundLength(perPixel, LONGEST_SHARE * first.map.width)
  return { pixels: length / perPixel, words: barWords(length) }
}
