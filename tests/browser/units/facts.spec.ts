/** What the engine knows is not typed again: the page follows it. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { EngineError, Layer, ScenarioSpec } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { en } from '../../../www/src/i18n/en/page'
import { zhCN } from '../../../www/src/i18n/zh_cn/page'
import { FACTS, type Facts } from '../../../www/src/model/facts'
import { layerChoices } from '../../../www/src/model/session'
import { groundOf } from '../../../www/src/model/terrain'
import { documentOf, readDocument } from '../../../www/src/share/session_document'
import { RacePage } from '../race_page'
import { sessionOf } from './sessions'

const PKG = join(__dirname, '../../../pkg')

async function wholeEngine(): Promise<typeof import('@pkg/formicarium')> {
  const engine = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  return engine
}

test('the facts are those of the engine', async () => {
  const engine = await wholeEngine()
  const { format: _, planners, ...known } = engine.catalog()
  const { memory, ...others } = FACTS
  expect(others).toEqual({ ...known, formats: engine.formats() })
  expect(Object.keys(memory)).toEqual(planners.map(({ id }) => id))
  const drawn = new Set(planners.flatMap(({ layers }) => layers))
  expect(FACTS.layers.filter((layer) => drawn.has(layer))).toEqual(FACTS.layers)
})

test('every layer, ground and generator has a text in both languages', () => {
  const { layers, grounds, generators } = FACTS
  for (const { view, panels, maps } of [en, zhCN]) {
    expect(Object.keys(view.layers).sort()).toEqual(layerChoices().sort())
    expect(Object.keys(view.layerNotes).sort()).toEqual([...layers].sort())
    // Weighted ground comes on top of the others.
    const all = [...grounds.map((r) => r.ground), 'weighted']
    expect(Object.keys(panels.otherGround).sort()).toEqual(all.sort())
    expect(Object.keys(maps.kind).sort()).toEqual(generators.map(({ id }) => id).sort())
  }
})

test('the menu of layers has those that the race can show, in the engine’s order', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const racing = (await race.session()).panels.map(({ planner }) => planner)
  const { planners } = (await wholeEngine()).catalog()
  const offered = planners.flatMap(({ id, layers }) => (racing.includes(id) ? layers : []))
  const options = page.getByTestId('layer').locator('option')
  const shown = await options.evaluateAll((all) => all.map((o) => (o as HTMLOptionElement).value))
  expect(shown).toEqual(layerChoices().filter((id) => id === 'none' || offered.includes(id)))
})

/** A document as a link carries it, with something else in it. */
function changed(change: (document: ReturnType<typeof documentOf>) => void) {
  const document = structuredClone(documentOf(sessionOf(8, 6), '0.1.0'))
  change(document)
  return document
}

const withLimits = (limits: Partial<Facts['limits']>): Facts => ({
  ...FACTS,
  limits: { ...FACTS.limits, ...limits },
})

test('sessions may show every layer that the engine has, and no other', () => {
  for (const layer of layerChoices())
    expect(readDocument(changed((d) => (d.layer = layer))).layer).toBe(layer)
  const other = changed((d) => (d.layer = 'smell'))
  expect(() => readDocument(other)).toThrow(/layer must be one of trail, .*, none/)
  const more = { ...FACTS, layers: [...FACTS.layers, 'smell' as Layer] }
  expect(readDocument(other, more).layer).toBe('smell')
})

test('limits of sessions are those of the engine', () => {
  const origin = { generator: 'cave', seed: 1, density: 0.5 }
  const slices = { level: 1, levels: 9, max_aside: 2, max_climb: 1, start_level: 1, goal_level: 1 }
  const document = changed(({ scenario }) =>
    Object.assign(scenario as object, {
      origin,
      terrain: { vertical_unit: 1, slices: { ...slices, measure: 'cost' } },
    }),
  )
  expect(readDocument(document).origin).toEqual(origin)
  const tighter: [Partial<Facts['limits']>, RegExp][] = [
    [{ max_side: 7 }, /width is 8; at most 7/],
    [{ max_goals: 0 }, /goals has 1 entries; at most 0/],
    [{ max_density: 0.4 }, /density must be a number from 0 to 0.4/],
    [{ max_levels: 8 }, /levels must be a number from 1 to 8/],
    [{ max_reach: 1 }, /max_aside must be a number from 0 to 1/],
  ]
  for (const [limits, refusal] of tighter)
    expect(() => readDocument(document, withLimits(limits))).toThrow(refusal)
  const fewer = { ...FACTS, generators: FACTS.generators.filter(({ id }) => id !== 'cave') }
  expect(() => readDocument(document, fewer)).toThrow(/generator must be one of/)
  const larger = changed(({ scenario }) =>
    Object.assign(scenario as object, { width: FACTS.limits.max_side + 1 }),
  )
  expect(() => readDocument(larger)).toThrow(/at most/)
  expect(readDocument(larger, withLimits({ max_side: 1e6 })).spec.width).toBe(
    FACTS.limits.max_side + 1,
  )
})

test('the ground of a scenario is the engine’s, for every planner', async () => {
  const engine = await wholeEngine()
  const { spec: plane, cells } = sessionOf(8, 8, new Uint8Array(64)).scenario
  const heights = new Float32Array(64)
  const slices = { level: 1, levels: 5, max_aside: 2, max_climb: 2, start_level: 1, goal_level: 1 }
  const terrains: (ScenarioSpec['terrain'] | undefined)[] = [
    undefined,
    { vertical_unit: 1, max_slope: 90 },
    { vertical_unit: 1, slices: { ...slices, measure: 'cost' } },
  ]
  const found = new Set<string>()
  for (const terrain of terrains)
    for (const moves of [4, 8, 16] as const) {
      const movement = { moves, corner_rule: 'both-free' } as const
      const spec: ScenarioSpec = { ...plane, movement, ...(terrain && { terrain }) }
      found.add(groundOf(spec))
      for (const { id, grounds } of engine.catalog().planners) {
        let refusal: string | null = null
        try {
          new engine.Run(spec, cells, terrain ? heights : undefined, null, id, {}, 1).free()
        } catch (thrown) {
          refusal = (thrown as EngineError).kind
        }
        expect(refusal, `${id} with ${moves} moves`).toBe(
          grounds.includes(groundOf(spec)) ? null : 'ground',
        )
      }
    }
  expect([...found].sort()).toEqual(FACTS.grounds.map(({ ground }) => ground).sort())
})
