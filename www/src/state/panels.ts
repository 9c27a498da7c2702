/** Which planners race, and with which parameters. */

import type { ParamSpec } from '@pkg/formicarium'
import { batch, signal } from '@preact/signals'
import type { ParamValues } from '../model/messages'
import { MAX_PANELS, type PanelSetup } from '../model/session'
import { dropRun, reset, restart } from './runs'
import {
  blankLive,
  type Panel,
  panelById,
  panels,
  plannerEntry,
  seed,
  selectedPanel,
} from './store'

let nextId = 1

/** By panel the set from which its own values were changed: where a reset leads. */
const startedFrom = new Map<number, string>()

/** The preset that the panel's values came from; null for the catalog's defaults. */
export const baseSet = ({ id, setup }: Panel): string | null =>
  setup.preset ?? startedFrom.get(id) ?? null

export function makePanel(setup: PanelSetup, slot: number): Panel {
  return { id: nextId++, slot, setup, live: signal(blankLive()), past: signal(null) }
}

export const bareSetup = (planner: string): PanelSetup => ({
  planner,
  preset: null,
  params: {},
  label: null,
  result: null,
})

/** A planner with a paper's values; with its own where the preset is unknown. */
export function presetSetup(planner: string, name: string | null): PanelSetup {
  const preset = plannerEntry(planner)?.presets.find((each) => each.name === name)
  return { ...bareSetup(planner), preset: preset?.name ?? null, params: { ...preset?.values } }
}

/** Replaces all planners; the caller loads their runs. */
export function replacePanels(setups: PanelSetup[]): void {
  for (const { id } of panels.peek()) dropRun(id)
  panels.value = setups.slice(0, MAX_PANELS).map(makePanel)
  selectedPanel.value = panels.value[0]?.id ?? null
}

export function addPanel(planner: string): void {
  const now = panels.peek()
  if (now.length >= MAX_PANELS) return
  const slot = freeSlot(now)
  const panel = makePanel(bareSetup(planner), slot)
  batch(() => {
    panels.value = [...now, panel]
    selectedPanel.value = panel.id
    restart()
  })
}

export function removePanel(id: number): void {
  const rest = panels.peek().filter((panel) => panel.id !== id)
  batch(() => {
    panels.value = rest
    if (selectedPanel.peek() === id) selectedPanel.value = rest[0]?.id ?? null
  })
  dropRun(id)
  if (rest.length === 0) reset()
}

export function setPlanner(id: number, planner: string): void {
  startedFrom.delete(id)
  changeSetup(id, () => bareSetup(planner))
}

/** A value that equals the default is left out, so that links stay short and sets compare equal. */
export function setParam(id: number, key: string, value: ParamValues[string]): void {
  const base = panelById(id)?.setup.preset
  if (base) startedFrom.set(id, base)
  changeSetup(id, (setup) => {
    const params = { ...setup.params }
    const spec = plannerEntry(setup.planner)?.params.find((param) => param.key === key)
    if (spec && spec.default === value) delete params[key]
    else params[key] = value
    return { ...setup, params, preset: null, result: null }
  })
}

/** A named set of a paper; null brings the defaults back. */
export function setPreset(id: number, name: string | null): void {
  startedFrom.delete(id)
  changeSetup(id, ({ planner, label }) => ({ ...presetSetup(planner, name), label }))
}

/** Values as they were together with the set that they came from. */
export function setValues(id: number, values: Pick<PanelSetup, 'preset' | 'params'>): void {
  startedFrom.delete(id)
  changeSetup(id, (setup) => ({ ...setup, ...values, result: null }))
}

export function setSeed(value: number): void {
  if (!Number.isInteger(value) || value < 0 || value > 0xffffffff) return
  batch(() => {
    seed.value = value
    dropResults()
    restart()
  })
}

/** Recorded results hold for one map, one seed and one set of parameters only. */
export function dropResults(): void {
  panels.value = panels.peek().map((panel) => {
    panel.live.value = { ...panel.live.peek(), verified: 'none' }
    return panel.setup.result ? { ...panel, setup: { ...panel.setup, result: null } } : panel
  })
}

export function paramValue(
  setup: Pick<PanelSetup, 'params'>,
  spec: ParamSpec,
): ParamValues[string] {
  return setup.params[spec.key] ?? spec.default
}

function changeSetup(id: number, change: (setup: PanelSetup) => PanelSetup): void {
  const panel = panelById(id)
  if (!panel) return
  const setup = change(panel.setup)
  batch(() => {
    panel.live.value = { ...panel.live.peek(), verified: 'none' }
    panels.value = panels.peek().map((each) => (each.id === id ? { ...each, setup } : each))
    restart()
  })
}

function freeSlot(taken: Panel[]): number {
  const slots = new Set(taken.map((panel) => panel.slot))
  let slot = 0
  while (slots.has(slot)) slot++
  return slot
}
