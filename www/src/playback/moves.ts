/** The moves of an ant from a cell, as rows to be read and drawn. */
import type { PanelAnswers } from '../model/messages'

export interface Move {
  /** Which of the planner's colonies: the leg of a tour, of two teams 1 for the one from the goal. */
  colony: number
  x: number
  y: number
  level: number
  trail: number
  heuristic: number
  /** τ^α·η^β as ants weigh it; 0 for what an ant has visited. */
  weight: number
  probability: number
}

/** Numbers in a row of `Run.moves_from`. */
const ROW = 8

export function movesOf({ rows }: PanelAnswers['moves']): Move[] {
  return Array.from({ length: rows.length / ROW }, (_, row) => {
    const [colony = 0, x = 0, y = 0, level = 0] = rows.subarray(row * ROW)
    const [trail = 0, heuristic = 0, weight = 0, probability = 0] = rows.subarray(row * ROW + 4)
    return { colony, x, y, level, trail, heuristic, weight, probability }
  })
}

/** Clockwise from the north; of those in one direction the nearer first, then the lower. */
export function byDirection(moves: Move[], from: [number, number]): Move[] {
  const turn = (move: Move) => (headingOf(move, from) + 90 + 360) % 360
  const away = ({ x, y }: Move) => Math.hypot(x - from[0], y - from[1])
  return moves.toSorted((a, b) => turn(a) - turn(b) || away(a) - away(b) || a.level - b.level)
}

/** Degrees clockwise from the east, as arrows are turned on a screen. */
export function headingOf({ x, y }: Pick<Move, 'x' | 'y'>, from: [number, number]): number {
  return (Math.atan2(y - from[1], x - from[0]) * 180) / Math.PI
}

/** The colonies that choose here, in order. */
export function coloniesOf(moves: Move[]): number[] {
  return [...new Set(moves.map(({ colony }) => colony))].sort((a, b) => a - b)
}
