import { expect, test } from '@playwright/test'
import { applyEditTo, lineCells } from '../../../www/src/model/edit'
import { resized } from '../../../www/src/model/resize'
import { createHistory } from '../../../www/src/state/history'
import { sessionOf } from './sessions'

const blank = () => sessionOf(10, 6, new Uint8Array(60)).scenario
const walls = (cells: Uint8Array) => cells.reduce((sum, cell) => sum + cell, 0)

test.describe('map edits', () => {
  test('a line joins its ends without holes, in every direction', () => {
    for (const to of [
      [9, 0],
      [9, 5],
      [0, 5],
      [3, 5],
      [9, 2],
    ] as [number, number][]) {
      for (const [from, end] of [
        [[0, 0], to],
        [to, [0, 0]],
      ] as [[number, number], [number, number]][]) {
        const cells = lineCells(from, end)
        expect(cells[0]).toEqual(from)
        expect(cells.at(-1)).toEqual(end)
        for (let i = 1; i < cells.length; i++) {
          const [a, b] = [cells[i - 1] ?? from, cells[i] ?? from]
          expect(Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]))).toBe(1)
        }
      }
    }
  })

  test('painting leaves start, goal and the outside alone, and the original untouched', () => {
    const before = blank()
    const after = applyEditTo(before, { kind: 'paint', from: [-3, 0], to: [12, 0], blocked: true })
    expect(walls(after.cells)).toBe(9)
    expect(after.cells[0]).toBe(0)
    expect(walls(before.cells)).toBe(0)
  })

  test('an edit that changes nothing gives the same object back', () => {
    const scenario = blank()
    expect(applyEditTo(scenario, { kind: 'paint', from: [2, 2], to: [4, 2], blocked: false })).toBe(
      scenario,
    )
    expect(applyEditTo(scenario, { kind: 'clear' })).toBe(scenario)
    expect(resized(scenario, 10, 6)).toBe(scenario)
    expect(applyEditTo(scenario, { kind: 'start', at: [9, 5] })).toBe(scenario)
    expect(applyEditTo(scenario, { kind: 'goal', index: 0, at: [10, 5] })).toBe(scenario)
  })

  test('start and goal free the cell they are put on', () => {
    const walled = applyEditTo(blank(), { kind: 'paint', from: [0, 3], to: [9, 3], blocked: true })
    const moved = applyEditTo(walled, { kind: 'goal', index: 0, at: [4, 3] })
    expect(moved.spec.goals).toEqual([
      { at: [4, 3], name: 'berth', area: 2, strength: 0.5, danger: 1 },
    ])
    expect(walls(moved.cells)).toBe(9)
  })

  test('resizing keeps the upper left part and both ends inside, apart and free', () => {
    const walled = applyEditTo(blank(), { kind: 'paint', from: [3, 0], to: [3, 5], blocked: true })
    const small = resized(walled, 4, 3)
    expect([small.spec.width, small.spec.height, small.cells.length]).toEqual([4, 3, 12])
    expect(small.spec.goals[0]?.at).toEqual([3, 2])
    expect([...small.cells]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0])
    const dot = resized(walled, 2, 1)
    expect(dot.spec.start).not.toEqual(dot.spec.goals[0]?.at)
    const large = resized(walled, 20, 20)
    expect(walls(large.cells)).toBe(6)
  })
})

test.describe('undo', () => {
  test('a gesture is one step, and a new edit forgets what was undone', () => {
    const history = createHistory()
    let now = blank()
    const edit = (x: number, gesture?: number) => {
      const after = applyEditTo(now, { kind: 'paint', from: [x, 2], to: [x, 2], blocked: true })
      history.record(now, after, gesture)
      now = after
    }
    edit(1, 7)
    edit(2, 7)
    edit(3, 8)
    expect(walls(now.cells)).toBe(3)
    now = history.undo(now)?.scenario ?? now
    expect(walls(now.cells)).toBe(2)
    now = history.undo(now)?.scenario ?? now
    expect(walls(now.cells)).toBe(0)
    expect(history.canUndo.value).toBe(false)
    expect(history.undo(now)).toBeNull()
    now = history.redo(now)?.scenario ?? now
    expect(walls(now.cells)).toBe(2)
    edit(5)
    expect(history.canRedo.value).toBe(false)
  })

  test('huge maps keep fewer steps', () => {
    const history = createHistory()
    let now = sessionOf(4096, 4096, new Uint8Array(4096 * 4096)).scenario
    for (let x = 1; x < 12; x++) {
      const after = { ...now, spec: { ...now.spec, name: String(x) } }
      history.record(now, after)
      now = after
    }
    let steps = 0
    for (let back = history.undo(now); back; back = history.undo(back.scenario)) steps++
    expect(steps).toBeGreaterThan(0)
    expect(steps).toBeLessThan(11)
  })
})
