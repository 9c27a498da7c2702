/** The memory that a race is going to take, by what the build has measured of each planner. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { memory } from '../../../www/src/model/facts'
import { MOST_BYTES, memoryOf, UNASKED_BYTES } from '../../../www/src/model/memory'
import { sessionOf } from './sessions'

const PKG = join(__dirname, '../../../pkg')
const GIB = 2 ** 30
const racing = (planner: string, params = {}) => ({ planner, params, result: null })
const square = (side: number) => sessionOf(side, side, new Uint8Array()).scenario.spec

test('six colonies on the largest map are refused, an ordinary race never waits', () => {
  const six = Array.from({ length: 6 }, () => racing('ant-system'))
  expect(memoryOf(square(4096), six) / GIB).toBeGreaterThan(11)
  expect(memoryOf(square(4096), six.slice(0, 1))).toBeLessThan(MOST_BYTES)
  expect(memoryOf(square(4096), six.slice(0, 1))).toBeGreaterThan(UNASKED_BYTES)
  expect(memoryOf(square(256), six)).toBeLessThan(UNASKED_BYTES)
  expect(memoryOf(square(1024), [racing('ant-system'), racing('astar')])).toBeLessThan(
    UNASKED_BYTES,
  )
})

test('more ants, goals and recorded runs take more', () => {
  const one = memoryOf(square(1024), [racing('ant-system')])
  expect(memoryOf(square(1024), [racing('ant-system', { ants: 1024 })])).toBeGreaterThan(2 * one)
  const recorded = { ...racing('ant-system'), result: sessionOf(1, 1).panels[0]?.result ?? null }
  expect(memoryOf(square(1024), [recorded])).toBeGreaterThan(1.5 * one)
  const tour = square(1024)
  tour.goals = Array.from({ length: 5 }, () => tour.goals[0] as (typeof tour.goals)[0])
  expect(memoryOf(tour, [racing('fire')])).toBeGreaterThan(
    2 * memoryOf(square(1024), [racing('fire')]),
  )
})

test('an instance grows by about what was measured', async () => {
  const engine = await import(`${join(PKG, 'formicarium.js')}?memory`)
  const wasm = engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  const { spec } = sessionOf(512, 512, new Uint8Array(512 * 512)).scenario
  for (const planner of ['ant-system', 'astar', 'turn-aware']) {
    const before = wasm.memory.buffer.byteLength
    const run = new engine.Run(spec, new Uint8Array(512 * 512), null, null, planner, {}, 1)
    run.advance('move', 200)
    const grown = (wasm.memory.buffer.byteLength - before) / 512 ** 2
    expect(grown, planner).toBeLessThan(1.25 * (memory[planner]?.cell ?? 0))
  }
})
