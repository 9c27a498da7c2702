// Searches of the npm package `pathfinding`.
import { createRequire } from 'node:module'

const PF = createRequire(new URL('../../www/package.json', import.meta.url))('pathfinding')

const FINDERS = { 'npm-astar': PF.AStarFinder, 'npm-jps': PF.JumpPointFinder }

/** The lengths of shortest paths. A search leaves marks on its grid, so each gets a copy, as the package's documentation asks for. */
export function exact({ spec, cells }, { who, lines }) {
  const { width, height } = spec
  const row = (_, y) => Array.from(cells.subarray(y * width, (y + 1) * width))
  const grid = new PF.Grid(Array.from({ length: height }, row))
  const diagonalMovement = PF.DiagonalMovement.OnlyWhenNoObstacles
  const finder = new FINDERS[who]({ diagonalMovement, heuristic: PF.Heuristic.octile })
  return () => {
    const begin = performance.now()
    const paths = lines.map((line) => finder.findPath(...line, grid.clone()))
    const seconds = (performance.now() - begin) / 1000
    return { seconds, lengths: paths.map((path) => PF.Util.pathLength(path)) }
  }
}
