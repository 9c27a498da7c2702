/** One frame of a film on a canvas: captions and code here, the maps as the runs' workers draw them. */

import { FONT, LOOKS } from '../figures/look'
import { drawQrCode, type QrCode } from '../figures/qr_code'
import { fitting } from '../figures/svg'
import { goalName } from '../model/goals'
import type { PanelView } from '../model/messages'
import type { Scenario } from '../model/session'
import { placement } from '../model/viewpoint'
import { layerEnds } from '../state'
import { showContours } from '../state/relief'
import type { CopiedRun } from './copied_race'
import type { FrameBar } from './frame_bar'
import type { FrameLayout, Rect } from './frame_layout'
import type { FilmLook } from './settings'

export type Canvas = OffscreenCanvasRenderingContext2D

/** CSS pixels of a panel's shorter side, beyond which lines and marks grow with it. */
const PLAIN_SIDE = 420
const WHOLE_MAP = { zoom: 1, centreX: 0.5, centreY: 0.5 }

/** How a run's map is drawn in its place; ants are shown where moves are. */
export function viewOf(
  { colour }: Pick<CopiedRun, 'colour'>,
  { spec }: Scenario,
  { layer, theme }: FilmLook,
  { width, height }: Rect,
  showAnts: boolean,
): PanelView {
  const dpr = Math.max(1, Math.min(width, height) / PLAIN_SIDE)
  const size = { width, height, dpr }
  return {
    ...size,
    ...placement(WHOLE_MAP, size, spec),
    layer,
    ends: layerEnds.peek(),
    showAnts,
    showPath: true,
    showContours: showContours.peek(),
    hidden: false,
    theme,
    colour,
    goalNames: spec.goals.map((_, i) => goalName(spec, i)),
    cursor: null,
    cursorFocus: false,
  }
}

export interface FrameWords {
  title: string[]
  /** By panel: its name, its colour, and what it has reached. */
  panels: { name: string; colour: string; reached: string }[]
  /** Beside the first caption. */
  bar: FrameBar | null
  /** Below the code, or in its place. */
  code: string[]
}

export function drawFrame(
  canvas: Canvas,
  layout: FrameLayout,
  theme: FilmLook['theme'],
  maps: ImageBitmap[],
  words: FrameWords,
  code: QrCode | null,
): void {
  const look = LOOKS[theme]
  canvas.fillStyle = look.background
  canvas.fillRect(0, 0, canvas.canvas.width, canvas.canvas.height)
  canvas.textBaseline = 'alphabetic'
  canvas.textAlign = 'left'
  drawTitle(canvas, layout, words.title, theme)
  for (const [i, { caption, map }] of layout.panels.entries()) {
    const said = words.panels[i]
    const bar = i === 0 ? words.bar : null
    const room = bar ? drawBar(canvas, layout.letter, caption, bar, theme) : 0
    if (said) drawCaption(canvas, layout.letter, caption, { ...said, room }, theme)
    if (maps[i]) canvas.drawImage(maps[i], map.x, map.y)
  }
  if (layout.code) drawCode(canvas, layout, code, words.code, theme)
}

function drawTitle(
  canvas: Canvas,
  { title, letter }: FrameLayout,
  lines: string[],
  theme: FilmLook['theme'],
): void {
  for (const [i, line] of lines.entries()) {
    const font = i === 0 ? { size: 1.25 * letter, weight: 650 } : { size: letter, weight: 400 }
    canvas.fillStyle = i === 0 ? LOOKS[theme].text : LOOKS[theme].muted
    write(canvas, line, font, title.x, title.y + (1.5 * i + 1.1) * letter, title.width)
  }
}

function drawCaption(
  canvas: Canvas,
  letter: number,
  { x, y, width }: Rect,
  said: FrameWords['panels'][number] & { room: number },
  theme: FilmLook['theme'],
): void {
  const radius = 0.36 * letter
  canvas.fillStyle = said.colour
  canvas.beginPath()
  canvas.arc(x + radius, y + 0.72 * letter, radius, 0, 2 * Math.PI)
  canvas.fill()
  const left = x + 1.1 * letter
  canvas.fillStyle = LOOKS[theme].text
  const name = { size: letter, weight: 600 }
  write(canvas, said.name, name, left, y + 1.06 * letter, x + width - left)
  canvas.fillStyle = LOOKS[theme].muted
  const reached = { size: 0.86 * letter, weight: 400 }
  write(canvas, said.reached, reached, x, y + 2.3 * letter, width - said.room)
}

/** At the right end of a caption's second line; tells how much of it that takes. */
function drawBar(
  canvas: Canvas,
  letter: number,
  { x, y, width }: Rect,
  { pixels, words }: FrameBar,
  theme: FilmLook['theme'],
): number {
  canvas.font = `400 ${0.86 * letter}px ${FONT}`
  const taken = canvas.measureText(words).width + 0.4 * letter
  const right = x + width - taken
  const base = y + 2.3 * letter
  canvas.fillStyle = LOOKS[theme].muted
  canvas.fillText(words, right + 0.4 * letter, base)
  canvas.strokeStyle = LOOKS[theme].text
  canvas.lineWidth = Math.max(1, letter / 12)
  canvas.beginPath()
  for (const [px, py] of barCorners(right, base, pixels, letter)) canvas.lineTo(px, py)
  canvas.stroke()
  return taken + pixels + letter
}

/** From its left tick to its right one. */
export function barCorners(
  right: number,
  base: number,
  pixels: number,
  letter: number,
): [number, number][] {
  const left = right - pixels
  const top = base - 0.4 * letter
  return [
    [left, top],
    [left, base],
    [right, base],
    [right, top],
  ]
}

function drawCode(
  canvas: Canvas,
  { code: place, letter }: FrameLayout,
  code: QrCode | null,
  lines: string[],
  theme: FilmLook['theme'],
): void {
  if (!place) return
  const { square, words } = place
  if (code) drawQrCode(canvas, code, square.x, square.y, square.width)
  const top = code ? words.y : square.y + square.height / 2
  for (const [i, line] of lines.entries()) {
    canvas.fillStyle = i === 0 ? LOOKS[theme].text : LOOKS[theme].muted
    const font = { size: 0.86 * letter, weight: i === 0 ? 600 : 400 }
    canvas.textAlign = 'center'
    const middle = words.x + words.width / 2
    write(canvas, line, font, middle, top + (1.3 + 1.3 * i) * letter, words.width)
  }
}

function write(
  canvas: Canvas,
  text: string,
  { size, weight }: { size: number; weight: number },
  x: number,
  y: number,
  most: number,
): void {
  const font = (letters: number) => `${weight} ${letters}px ${FONT}`
  const shown = fitting(text, most, size, font)
  canvas.font = font(shown.size)
  canvas.fillText(shown.text, x, y)
}
