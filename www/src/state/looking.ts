/** What the reader looks back at, or into. The code that does it is fetched with the first look (playback/). */
import { batch, signal } from '@preact/signals'
import { client } from '../engine/panel_clients'
import type { Cell } from '../model/cell'
import type { Look, Session } from '../model/session'
import { type Panel, type PanelLive, panels } from './store'

/** The iteration that every panel shows; null for where the runs stand. */
export const lookedAt = signal<number | null>(null)

/** The cell whose moves are on show, in one panel; by slices at a level, null for the one at which there is most to tell. */
export const inspected = signal<InspectedHere | null>(null)

interface InspectedHere {
  panelId: number
  cell: Cell
  level: number | null
}

/** What an opened session looked at, until its runs have come that far (playback/arrival.ts). */
export const awaited = signal<{ look: number | null; inspected: InspectedHere | null } | null>(null)

/** To be called with the panels of the session in place. */
export function awaitLook({ look, inspected: there }: Session): void {
  const panelId = panels.peek()[there?.panel ?? -1]?.id
  const here = there && panelId !== undefined ? { ...there, panelId } : null
  inspected.value = null
  awaited.value = look === null && !here ? null : { look, inspected: here }
}

/** What is looked at, as a session says it: what the reader has chosen, or else what is still awaited. */
export function currentLook(): Look {
  const own = { look: lookedAt.peek(), inspected: inspected.peek() }
  const { look, inspected: here } = (own.look === null && !own.inspected && awaited.peek()) || own
  const panel = panels.peek().findIndex(({ id }) => id === here?.panelId)
  return {
    look,
    inspected: here && panel >= 0 ? { panel, cell: here.cell, level: here.level } : null,
  }
}

/** Whether a panel of its own compares the pheromone of two others. */
export const comparing = signal(false)

/** What a panel shows: what it has reached or, looking back, what it had. */
export function shownOf({ past, live }: Panel): PanelLive {
  return past.value ?? live.value
}

/** Back to the present. A run that has ended sends no frames, so its canvas must be told. */
export function leavePast(): void {
  if (lookedAt.peek() === null) return
  batch(() => {
    lookedAt.value = null
    for (const { id, past } of panels.peek()) {
      past.value = null
      void client(id)?.ask({ about: 'look', iteration: null })
    }
  })
}
