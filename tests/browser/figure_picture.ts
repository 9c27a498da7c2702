/** Draws the figure of a grid as papers print it: lines between cells, numbers at its sides, coloured ends, a path. */
import type { Page } from '@playwright/test'

/** Pixels of a cell, and of the white around the grid. */
export const SIDE = 18
export const MARGIN = 30

/** What is drawn in each cell: `.` free, `#` a wall, `S` the start, `G` the goal, `/` a wall that is half printed. */
export const DRAWN = [
  'S...#.......',
  '.##.#.####..',
  '.##...#.....',
  '......#.###.',
  '####..#.#...',
  '......#.#.#.',
  '.####...#.#.',
  '.#......#.#.',
  '.#.######.#.',
  '.#........#.',
  '.#######.##.',
  '..../......G',
]

/** Places in cells that a path goes through. */
const PATH = [
  [0.5, 0.5],
  [0.5, 3.5],
  [5.5, 3.5],
  [5.5, 7.5],
]

export async function figurePicture(page: Page, rows = DRAWN, lines = true): Promise<Buffer> {
  const base64 = await page.evaluate(draw, { rows, path: PATH, side: SIDE, margin: MARGIN, lines })
  return Buffer.from(base64, 'base64')
}

interface Drawing {
  rows: string[]
  path: number[][]
  side: number
  margin: number
  lines: boolean
}

/** In the page: a PNG as base64. */
function draw({ rows, path, side, margin, lines }: Drawing): string {
  const columns = rows[0]?.length ?? 0
  const canvas = document.createElement('canvas')
  canvas.width = 2 * margin + columns * side
  canvas.height = 2 * margin + rows.length * side
  const context = canvas.getContext('2d')
  if (!context) throw new Error('no canvas')
  context.fillStyle = '#fff'
  context.fillRect(0, 0, canvas.width, canvas.height)
  const colours: Record<string, string> = { '#': '#000', S: '#00a000', G: '#dc1414', '/': '#000' }
  rows.forEach((row, y) => {
    ;[...row].forEach((letter, x) => {
      context.fillStyle = colours[letter] ?? '#fff'
      const height = letter === '/' ? side / 2 : side
      context.fillRect(margin + x * side, margin + y * side, side, height)
    })
  })
  context.fillStyle = '#888'
  for (let i = 0; lines && i <= columns; i++)
    context.fillRect(margin + i * side, margin, 1, rows.length * side + 1)
  for (let i = 0; lines && i <= rows.length; i++)
    context.fillRect(margin, margin + i * side, columns * side + 1, 1)
  context.fillStyle = '#000'
  context.font = '10px sans-serif'
  for (let i = 0; lines && i < columns; i += 2) {
    context.fillText(String(i), margin + (i + 0.3) * side, margin - 8)
    context.fillText(String(i), margin - 18, margin + (i + 0.7) * side)
  }
  context.strokeStyle = '#2060e0'
  context.lineWidth = 3
  context.beginPath()
  for (const [x = 0, y = 0] of lines ? path : [])
    context.lineTo(margin + x * side, margin + y * side)
  context.stroke()
  return canvas.toDataURL('image/png').split(',')[1] ?? ''
}
