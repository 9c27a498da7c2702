/** The race as one picture: every panel as it stands, side by side. */

import { pngWith } from '../share/png'
import { type Panel, panels, slotColour } from '../state'
import { panelTitle } from '../words/planner_words'

const MOST_COLUMNS = 3
/** Pixels. */
const WIDEST = 900
const EDGE = 20
const HEAD = 44

/** PNG with a text inside, by which the page opens the race again. */
export async function racePicture(text: string): Promise<Uint8Array<ArrayBuffer>> {
  const shown = panels.peek().flatMap((panel, at) => stageOf(panel, at + 1) ?? [])
  const width = Math.max(1, ...shown.map(({ size }) => size.width))
  const height = Math.max(1, ...shown.map(({ size }) => size.height))
  const columns = Math.min(MOST_COLUMNS, Math.max(1, shown.length))
  const canvas = document.createElement('canvas')
  canvas.width = columns * (width + EDGE) + EDGE
  canvas.height = Math.ceil(shown.length / columns) * (height + HEAD + EDGE) + EDGE
  const context = canvas.getContext('2d')
  if (!context) throw new Error('the browser makes no picture')
  const style = getComputedStyle(document.documentElement)
  context.fillStyle = style.getPropertyValue('--ground').trim()
  context.fillRect(0, 0, canvas.width, canvas.height)
  for (const [at, stage] of shown.entries()) {
    const x = EDGE + (at % columns) * (width + EDGE)
    const y = EDGE + Math.floor(at / columns) * (height + HEAD + EDGE)
    heading(context, stage.panel, x, y, style)
    stage.draw(context, x, y + HEAD)
  }
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'))
  if (!blob) throw new Error('the browser makes no picture')
  return pngWith(new Uint8Array(await blob.arrayBuffer()), text)
}

interface Stage {
  panel: Panel
  size: { width: number; height: number }
  draw(context: CanvasRenderingContext2D, x: number, y: number): void
}

/** The visible canvases of a panel, from the bottom one up. */
function stageOf(panel: Panel, place: number): Stage | null {
  const host = document.querySelector(`[data-testid="panel-${place}"] .panel-stage`)
  const frame = host?.getBoundingClientRect()
  if (!host || !frame || frame.width === 0) return null
  const scale = Math.min(devicePixelRatio, WIDEST / frame.width)
  const size = { width: Math.round(frame.width * scale), height: Math.round(frame.height * scale) }
  const all = host.querySelectorAll<HTMLCanvasElement>(':not(.edit-preview) > canvas')
  const layers = [...all].filter((canvas) => canvas.offsetWidth > 0)
  const draw = (context: CanvasRenderingContext2D, x: number, y: number) => {
    for (const layer of layers) {
      const box = layer.getBoundingClientRect()
      const left = x + (box.x - frame.x) * scale
      const top = y + (box.y - frame.y) * scale
      context.drawImage(layer, left, top, box.width * scale, box.height * scale)
    }
  }
  return { panel, size, draw }
}

function heading(
  context: CanvasRenderingContext2D,
  { id, slot }: Panel,
  x: number,
  y: number,
  style: CSSStyleDeclaration,
): void {
  context.fillStyle = slotColour(slot)
  context.beginPath()
  context.arc(x + 8, y + 20, 7, 0, 2 * Math.PI)
  context.fill()
  context.fillStyle = style.getPropertyValue('--text').trim()
  context.font = `600 20px ${style.getPropertyValue('--font')}`
  context.fillText(panelTitle(id), x + 26, y + 27)
}
