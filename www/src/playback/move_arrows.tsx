/** The moves of a cell as arrows on the flat map, the wider the likelier. */
import type { Cell } from '../model/cell'
import { type CanvasSize, place } from '../stage/panel_view'
import { panelColour } from '../state'
import type { Move } from './moves'

interface MoveArrowsProps {
  cell: Cell
  moves: Move[]
  size: CanvasSize
  panelId: number
}

/** CSS pixels. */
const THINNEST = 1.25
const WIDEST = 9
/** On small cells arrows reach further than their cell, so that they can be told apart. */
const SHORTEST = 22

export function MoveArrows({ cell: [x, y], moves, size, panelId }: MoveArrowsProps) {
  const { scale, originX, originY } = place(size)
  const { dpr } = size
  const [fromX, fromY] = [(originX + (x + 0.5) * scale) / dpr, (originY + (y + 0.5) * scale) / dpr]
  return (
    <svg
      class="move-arrows"
      aria-hidden="true"
      width={size.width / dpr}
      height={size.height / dpr}
      style={{ color: panelColour(panelId) }}
      data-testid="move-arrows"
    >
      <rect
        class="from"
        x={fromX - scale / dpr / 2}
        y={fromY - scale / dpr / 2}
        width={scale / dpr}
        height={scale / dpr}
      />
      {byCell(moves).map((move) => (
        <Arrow
          key={`${move.x},${move.y}`}
          from={[fromX, fromY]}
          by={[((move.x - x) * scale) / dpr, ((move.y - y) * scale) / dpr]}
          share={move.probability}
        />
      ))}
    </svg>
  )
}

/** By slices several moves lead to one cell of the map. */
function byCell(moves: Move[]): Move[] {
  const sums = new Map<string, Move>()
  for (const move of moves) {
    const key = `${move.x},${move.y}`
    const sum = sums.get(key)
    sums.set(key, sum ? { ...sum, probability: sum.probability + move.probability } : move)
  }
  return [...sums.values()].sort((a, b) => a.probability - b.probability)
}

interface ArrowProps {
  from: [number, number]
  by: [number, number]
  share: number
}

function Arrow({ from: [x, y], by: [dx, dy], share }: ArrowProps) {
  const length = Math.hypot(dx, dy)
  const stretch = Math.max(0.86, SHORTEST / length)
  const width = THINNEST + (WIDEST - THINNEST) * Math.sqrt(share)
  const [endX, endY] = [x + dx * stretch, y + dy * stretch]
  const head = 3 + 1.1 * width
  const [ux, uy] = [dx / length, dy / length]
  const base: [number, number] = [endX - ux * head, endY - uy * head]
  const side = 0.62 * head
  const points = [
    [endX, endY],
    [base[0] - uy * side, base[1] + ux * side],
    [base[0] + uy * side, base[1] - ux * side],
  ]
  const shape = (
    <>
      <line x1={x + ux * 3} y1={y + uy * 3} x2={base[0]} y2={base[1]} />
      <polygon points={points.map((point) => point.join()).join(' ')} />
    </>
  )
  return (
    <>
      <g class="halo" style={{ strokeWidth: width + 3 }}>
        {shape}
      </g>
      <g class="arrow" style={{ strokeWidth: width, opacity: 0.7 + 0.3 * Math.sqrt(share) }}>
        {shape}
      </g>
    </>
  )
}
