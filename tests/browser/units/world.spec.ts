import { expect, test } from '@playwright/test'
import { resized } from '../../../www/src/model/resize'
import type { Scenario } from '../../../www/src/model/session'
import { placeOf } from '../../../www/src/model/world'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { sessionOf } from './sessions'

const WORLD = { x: 2, y: 3, yaw: 1, frame: 'map' }

function placed(width = 4, height = 3): Scenario {
  const { scenario } = sessionOf(width, height, new Uint8Array(width * height))
  return { ...scenario, spec: { ...scenario.spec, resolution: 0.5, world: WORLD } }
}

test('the lower left corner is the origin, about which the map is turned', () => {
  const { spec } = placed()
  expect(placeOf({ ...spec, world: { ...WORLD, yaw: 0 } }, [0, 2])).toEqual([2.25, 3.25])
  expect(placeOf({ ...spec, world: { ...WORLD, yaw: 0 } }, [3, 0])).toEqual([3.75, 4.25])
  const [x, y] = placeOf({ ...spec, world: { ...WORLD, yaw: Math.PI / 2 } }, [3, 2]) ?? []
  expect(x).toBeCloseTo(1.75, 9)
  expect(y).toBeCloseTo(4.75, 9)
  const { world: _, ...nowhere } = spec
  expect(placeOf(nowhere, [0, 0])).toBeNull()
})

test('cells stay where they are when rows and columns come and go', () => {
  const before = placed()
  for (const [width, height] of [
    [4, 2],
    [2, 3],
    [6, 5],
  ] as const) {
    const { spec } = resized(before, width, height)
    expect([spec.width, spec.height]).toEqual([width, height])
    const [was, is] = [placeOf(before.spec, [1, 1]), placeOf(spec, [1, 1])]
    expect(is?.[0]).toBeCloseTo(was?.[0] ?? 0, 9)
    expect(is?.[1]).toBeCloseTo(was?.[1] ?? 0, 9)
  }
})

test('a session carries the place, and what is no place is refused by name', () => {
  const session = sessionOf(4, 3, new Uint8Array(12))
  const plain = JSON.parse(JSON.stringify(documentOf(session, '0')))
  expect('world' in plain.scenario).toBe(false)
  expect('world' in readDocument(plain).spec).toBe(false)
  const withWorld = (world: unknown) => ({ ...plain, scenario: { ...plain.scenario, world } })
  expect(readDocument(withWorld(WORLD)).spec.world).toEqual(WORLD)
  expect(readDocument(withWorld({ x: 1, y: 2 })).spec.world).toEqual({
    x: 1,
    y: 2,
    yaw: 0,
    frame: '',
  })
  for (const [wrong, field] of [
    [{ ...WORLD, x: 1e10 }, 'world.x'],
    [{ ...WORLD, y: '3' }, 'world.y'],
    [{ ...WORLD, yaw: 2000 }, 'world.yaw'],
    [{ ...WORLD, frame: 'm'.repeat(81) }, 'world.frame'],
    [7, 'world'],
  ] as const)
    expect(() => readDocument(withWorld(wrong)), field).toThrow(field)
})
