/** Where things stand in a frame: title and note, maps with their captions, the code. All in pixels; pure functions. */
import { panelLayout } from '../model/panel_layout'
import type { FilmSize } from './settings'

export interface Rect {
  x: number
  y: number
  width: number
  height: number
}

export interface FrameLayout {
  /** The size of letters, from which all distances follow. */
  letter: number
  edge: number
  title: Rect
  /** The place of each panel's caption and of its map. */
  panels: { caption: Rect; map: Rect }[]
  /** A square for the code, and the room for words beside or below it; null where none is shown. */
  code: { square: Rect; words: Rect } | null
}

const CAPTION_LETTERS = 2.9

interface Asked {
  count: number
  map: FilmSize
  /** Lines at the top. */
  titleLines: number
  /** The share of the longer side that the code takes; 0 for none. */
  code: number
}

export function layOut({ width, height }: FilmSize, asked: Asked): FrameLayout {
  const letter = Math.max(9, Math.round(Math.min(width, height) / 28))
  const edge = letter
  const whole = { x: edge, y: edge, width: width - 2 * edge, height: height - 2 * edge }
  const titleHeight =
    asked.titleLines === 0 ? 0 : Math.round((1.5 * asked.titleLines + 0.6) * letter)
  const title = { ...whole, height: titleHeight }
  const below = without(whole, titleHeight)
  const { field, code } =
    asked.code > 0 ? withCode(below, letter, asked.code) : { field: below, code: null }
  return { letter, edge, title, panels: grid(field, letter, asked), code }
}

const without = (rect: Rect, taken: number): Rect => ({
  ...rect,
  y: rect.y + taken,
  height: rect.height - taken,
})

/** The code takes the right part of a wide field, the lower part of a tall one. */
function withCode(
  field: Rect,
  letter: number,
  share: number,
): { field: Rect; code: FrameLayout['code'] } {
  const words = 4 * letter
  if (field.width >= field.height) {
    const side = Math.floor(Math.min(field.height - words, share * field.width))
    const left = field.x + field.width - side
    const y = field.y + Math.floor((field.height - side - words) / 2)
    const square = { x: left, y, width: side, height: side }
    const text = { x: left, y: y + side, width: side, height: words }
    return {
      field: { ...field, width: field.width - side - 2 * letter },
      code: { square, words: text },
    }
  }
  const side = Math.floor(Math.min(field.width, share * field.height - words))
  const top = field.y + field.height - side - words
  const square = {
    x: field.x + Math.floor((field.width - side) / 2),
    y: top,
    width: side,
    height: side,
  }
  const text = { ...square, x: field.x, width: field.width, y: top + side, height: words }
  return {
    field: { ...field, height: field.height - side - words - letter },
    code: { square, words: text },
  }
}

function grid(field: Rect, letter: number, { count, map }: Asked): FrameLayout['panels'] {
  const caption = Math.round(CAPTION_LETTERS * letter)
  const { columns } = panelLayout(count, field, map, { head: caption, border: 0, gap: letter })
  const cell = cellOf(field, letter, columns, Math.ceil(count / columns))
  const room = { width: cell.width, height: cell.height - caption }
  const size = fitted(room, map)
  return Array.from({ length: count }, (_, i) => {
    const left = field.x + (i % columns) * (cell.width + letter)
    const top = field.y + Math.floor(i / columns) * (cell.height + letter)
    const x = Math.round(left + (room.width - size.width) / 2)
    const y = Math.round(top + (room.height - size.height) / 2)
    const width = Math.floor(left + cell.width - x - letter / 2)
    return { caption: { x, y, width, height: caption }, map: { x, y: y + caption, ...size } }
  })
}

/** As large as a map can be in a room, so that its caption stands close above it. */
function fitted(room: FilmSize, map: FilmSize): FilmSize {
  const scale = Math.min(room.width / map.width, room.height / map.height)
  return {
    width: Math.max(1, Math.floor(map.width * scale)),
    height: Math.max(1, Math.floor(map.height * scale)),
  }
}

const cellOf = (field: Rect, gap: number, columns: number, rows: number) => ({
  width: (field.width - gap * (columns - 1)) / columns,
  height: (field.height - gap * (rows - 1)) / rows,
})
