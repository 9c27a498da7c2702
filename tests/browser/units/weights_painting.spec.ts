/** How weighted ground and a robot's room look, and what the engine says of them. */
import type { Robot } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { numbersOf } from '../../../www/src/model/cell_numbers'
import { Paper, wholeEngine } from './paper'
import { randomCells, sessionOf } from './sessions'

const light = ([r = 0, g = 0, b = 0]: number[]) => 0.2126 * r + 0.7152 * g + 0.0722 * b

/** Half a metre a cell, a wall in the middle: a robot of half a metre does not fit beside it. */
function beside(robot: Robot) {
  const { spec, cells } = sessionOf(5, 3, new Uint8Array(15)).scenario
  cells[7] = 1
  return { spec: { ...spec, robot }, cells }
}
const NARROW = [2, 6, 8, 12]

for (const theme of ['light', 'dark'] as const)
  test(`the dearer the ground the stronger its tint, up to ten: ${theme}`, async () => {
    const engine = await wholeEngine()
    const paper = new Paper()
    const { spec, cells } = sessionOf(5, 1, new Uint8Array(5)).scenario
    const factors = Float32Array.of(1, 1.5, 3, 10, 100)
    engine.paint_map(paper.context, spec, cells, null, factors, theme, true)
    const [plain = [], ...dear] = paper.cells
    expect(plain.slice(0, 3)).toEqual([...engine.map_colors('none', theme).slice(0, 3)])
    const strengths = [plain, ...dear].map((cell) => Math.abs(light(cell) - light(plain)))
    expect(strengths.slice(0, 4)).toEqual(strengths.slice(0, 4).sort((a, b) => a - b))
    expect(new Set(strengths).size).toBe(4)
    expect(dear[3]).toEqual(dear[2])

    const list = [...engine.weight_colors(theme)]
    const tints = Array.from({ length: 256 }, (_, i) => light(list.slice(3 * i + 6, 3 * i + 9)))
    const falling = theme === 'light' ? tints : [...tints].reverse()
    expect(falling).toEqual([...falling].sort((a, b) => b - a))
    expect(list.slice(0, 3)).toEqual(plain.slice(0, 3))
    expect(list.slice(-3)).toEqual(dear[2]?.slice(0, 3))
  })

test('where a robot does not fit is neither ground nor wall, and half clear for the hatching', async () => {
  const engine = await wholeEngine()
  const paper = new Paper()
  const { spec, cells } = beside({ radius: 0.5 })
  engine.paint_map(paper.context, spec, cells, null, null, 'light', true)
  const painted = paper.cells
  const [free, wall] = [painted[0], painted[7]]
  for (const [at, cell] of painted.entries()) {
    if (NARROW.includes(at)) {
      expect(cell[3]).toBe(150)
      expect([free, wall].map((other) => other?.slice(0, 3))).not.toContainEqual(cell.slice(0, 3))
    } else expect(cell).toEqual(at === 7 ? wall : free)
  }
  engine.paint_map(paper.context, spec, cells, null, null, 'light', false)
  expect(paper.cells.every(([, , , opacity]) => opacity === 255)).toBe(true)
  const run = new engine.Run(spec, cells, null, null, 'astar', {}, 1)
  run.paint(paper.context, 'none', 'light', true, null)
  expect(paper.cells).toEqual(painted)
  run.free()
})

test('the map as the robot feels it is told, whether or not it has room at its ends', async () => {
  const engine = await wholeEngine()
  const inflation = { radius: 0.55, cost_scaling: 10, rule: 'nav2-smac-2d', multiplier: 2 } as const
  const { spec, cells } = beside({ radius: 0.5, inflation })
  const squeezed = { ...spec, start: [1, 1] as [number, number] }
  for (const asked of [spec, squeezed]) {
    const { blocked, factors } = engine.felt_map(asked, cells)
    const narrow = [...blocked.keys()].filter((cell) => blocked[cell] === 1)
    expect(narrow).toEqual([2, 6, 7, 8, 12])
    // Diagonally beside the wall: ⌊252 · exp(−10 · (√½ − ½))⌋ = 31.
    expect(numbersOf(factors)?.[1]).toBe(Math.fround(1 + (2 * 31) / 252))
  }
  expect(engine.felt_map({ ...spec, robot: { radius: 0 } }, cells).factors).toHaveLength(0)
  const refused = () => new engine.Run(squeezed, cells, null, null, 'astar', {}, 1)
  expect(refused).toThrow(expect.objectContaining({ kind: 'start-too-narrow' }))
  const wrong = { ...spec, robot: { radius: -1 } }
  expect(() => engine.felt_map(wrong, cells)).toThrow(
    expect.objectContaining({ field: 'robot.radius' }),
  )
})

test('on weighted ground too a picture that was kept is the one that would be painted anew', async () => {
  const engine = await wholeEngine()
  const paper = new Paper()
  const { spec, cells } = sessionOf(12, 12, randomCells(12, 12, 0.1)).scenario
  cells[0] = 0
  cells[143] = 0
  const factors = Float32Array.from({ length: 144 }, (_, i) => 1 + (i % 7))
  const begin = () => new engine.Run(spec, cells, null, factors, 'ant-system', {}, 3)
  const kept = begin()
  for (let moves = 0; moves < 20; moves++) {
    const anew = begin()
    anew.advance('move', moves)
    for (const [layer, theme] of [
      ['trail', 'light'],
      ['none', 'dark'],
      ['visits', 'light'],
    ] as const) {
      anew.paint(paper.context, layer, theme, true, null)
      const right = paper.pixels
      kept.paint(paper.context, layer, theme, true, null)
      expect(paper.pixels, `${layer} after ${moves} moves`).toBe(right)
    }
    anew.free()
    kept.advance('move', 1)
  }
  kept.free()
})
