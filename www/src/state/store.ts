/**
 * The signals every part of the page reads. What a run depends on is changed by the actions beside this file alone; mere choices of
 * the reader (tool, layer, speed, …) are written where they are made.
 */

import type {
  Catalog,
  CatalogEntry,
  EngineError,
  Layer,
  Notice,
  Objective,
  Reference,
  RunSummary,
} from '@pkg/formicarium'
import { computed, type Signal, signal } from '@preact/signals'
import type { Verification } from '../model/scripting'
import {
  type Caption,
  DEFAULT_SPEED,
  type PanelSetup,
  type Scenario,
  type Sync,
} from '../model/session'
import { slotColour } from './slot_colours'

/** editing: nothing has run since the last change · running · paused · finished: every panel has ended */
export type Phase = 'editing' | 'running' | 'paused' | 'finished'

/** What a panel's run has reached. It changes many times a second, so it is a signal of its own. */
export interface PanelLive {
  summary: RunSummary | null
  /** The objective: known as soon as the run is loaded, and kept while the next one loads. */
  objective: Objective | null
  /** Best path, x0, y0, x1, y1, …; null when none yet. */
  bestPath: Uint32Array | null
  /** Altitude in metres of each of its places; empty on a plane. */
  bestAltitudes: Float64Array | null
  error: EngineError | null
  /** Why the worker is gone: it has failed, or could not be fetched. */
  crashed: EngineError | null
  verified: Verification
}

/** A panel on the page. `id` is stable while the panel lives; the worker behind it is found by it. */
export interface Panel {
  id: number
  /** Which colour and place name it has: the smallest free number when it was added. */
  slot: number
  setup: PanelSetup
  live: Signal<PanelLive>
  /** What it had reached at the iteration being looked back at; null for the present. */
  past: Signal<PanelLive | null>
}

/** Not asked for · on its way · here, and its planners in the catalog · not to be had, until asked for again */
export type WholeEngineState = 'absent' | 'fetching' | 'here' | 'failed'

/** Draws more than one cell after the other, or takes up a part of the map (editor/). */
export type FurtherTool = 'line' | 'rectangle' | 'block' | 'fill' | 'ground' | 'select'
export type Tool =
  | 'wall'
  | 'erase'
  | 'start'
  | 'goal'
  | 'add-goal'
  | 'inspect'
  | 'pan'
  | FurtherTool

export const catalog = signal<Pick<Catalog, 'planners'> | null>(null)
/** Once it is here the catalog is complete: until then it lists the planners of the core. */
export const wholeEngine = signal<WholeEngineState>('absent')
export const engineVersion = signal('')
/** Set when the engine could not be started at all. */
export const startError = signal<EngineError | null>(null)

export const scenario = signal<Scenario | null>(null)
/** Key of the built-in scenario the map came from, until it is edited. */
export const galleryId = signal<string | null>(null)
/** What the engine says about the scenario as a whole (e.g. the goal cannot be reached). */
export const scenarioNotices = signal<Notice[]>([])
/** The references of the current scenario, by objective; absent while they are being computed. */
export const references = signal<Partial<Record<Objective, Reference>>>({})
/** Why the current scenario has no reference and will get none: it cannot be used, or the engine stopped. */
export const referenceRefusal = signal<Notice | null>(null)

/** What the reader calls the session, and says of it. */
export const caption = signal<Caption>({ title: '', note: '' })

export const panels = signal<Panel[]>([])
/** The panel whose parameters are on show. */
export const selectedPanel = signal<number | null>(null)
export const seed = signal(1)
export const sync = signal<Sync>('moves')
export const speed = signal(DEFAULT_SPEED)
export const phase = signal<Phase>('editing')

export const tool = signal<Tool>('wall')
/** Whether a pointer is drawing. */
export const pressed = signal(false)
/** The goal that the goal tool moves: the one last taken up. */
export const activeGoal = signal(0)
/** Whether the table of goals is on show though there is only one goal. */
export const goalsShown = signal(false)
export const layer = signal<Layer | 'none'>('trail')
export const showAnts = signal(true)
export const showPath = signal(true)

/** Grows whenever live values were flushed (at most about eight times a second); charts redraw on it. */
export const liveTick = signal(0)

export const blankLive = (): PanelLive => ({
  summary: null,
  objective: null,
  bestPath: null,
  bestAltitudes: null,
  error: null,
  crashed: null,
  verified: 'none',
})

export const playing = computed(() => phase.value === 'running')

/** Undefined for a planner that is not in the catalog, or not yet. */
export function plannerEntry(id: string): CatalogEntry | undefined {
  return catalog.value?.planners.find((entry) => entry.id === id)
}

export function panelById(id: number): Panel | undefined {
  return panels.value.find((panel) => panel.id === id)
}

export function panelColour(panelId: number): string {
  return slotColour(panelById(panelId)?.slot ?? 0)
}
