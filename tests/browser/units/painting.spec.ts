/** What a run paints: a picture that was kept is the one that would be painted anew. */
import type { Layer } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { Paper, wholeEngine } from './paper'
import { randomCells, sessionOf } from './sessions'

const SIDE = 14

const LOOKS: ['light' | 'dark', number[] | null][] = [
  ['light', null],
  ['dark', null],
  ['dark', [0, 2]],
  ['light', [0, 0.5]],
  ['light', null],
]

test('a picture that was kept is the one that would be painted anew', async () => {
  const engine = await wholeEngine()
  const { spec, cells } = sessionOf(SIDE, SIDE, randomCells(SIDE, SIDE, 0.2)).scenario
  cells[0] = 0
  cells[cells.length - 1] = 0
  const paper = new Paper()
  const { context } = paper
  for (const planner of ['ant-system', 'ant-colony-system', 'ship', 'pso-aco', 'astar']) {
    const begin = () => new engine.Run(spec, cells, null, null, planner, {}, 3)
    const kept = begin()
    const layers: (Layer | 'none')[] = ['none', ...kept.layers()]
    const painted = new Map<string, string>()
    for (let moves = 0; moves < 40; moves++) {
      const anew = begin()
      anew.advance('move', moves)
      for (const layer of layers)
        for (const [theme, ends] of LOOKS) {
          anew.paint(context, layer, theme, true, ends)
          const right = paper.pixels
          kept.paint(context, layer, theme, true, ends)
          expect(paper.pixels, `${planner}, ${layer}, ${theme} after ${moves} moves`).toBe(right)
          const look = `${kept.moment(layer)} ${layer} ${theme} ${ends}`
          expect(painted.get(look) ?? right, `${planner}: ${look}`).toBe(right)
          painted.set(look, right)
        }
      anew.free()
      kept.advance('move', 1)
    }
    kept.free()
  }
})

test('what has not changed need not be painted again', async () => {
  const engine = await wholeEngine()
  const { spec, cells } = sessionOf(SIDE, SIDE, new Uint8Array(SIDE * SIDE)).scenario
  const run = new engine.Run(spec, cells, null, null, 'ant-system', { iterations: 9 }, 3)
  const moments = () =>
    (['none', 'heuristic', 'trail', 'visits'] as const).map((layer) => `${run.moment(layer)}`)
  run.advance('move', 1)
  const [map, eta, trail, visits] = moments()
  expect(moments()).toEqual([map, eta, trail, visits])
  run.advance('move', 1)
  expect(moments().slice(0, 3)).toEqual([map, eta, trail])
  expect(moments()[3]).not.toBe(visits)
  run.advance('iteration', 1)
  expect(moments().slice(0, 2)).toEqual([map, eta])
  expect(moments()[2]).not.toBe(trail)
  const now = moments()
  expect(run.show_iteration(0, 100)).toBe(true)
  for (const [at, moment] of moments().entries()) expect(moment).not.toBe(now[at])
  run.free()
})
