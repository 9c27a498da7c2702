/** Goes to what an opened session looked at: the iteration once the runs have come so far, and the cell. */
import { batch, effect, untracked } from '@preact/signals'
import { numbers } from '../i18n'
import { t } from '../i18n/names'
import type { Scenario } from '../model/session'
import {
  announce,
  dismiss,
  inspected,
  notify,
  notifyError,
  panelById,
  panels,
  plannerEntry,
  runToEnd,
  scenario,
  seed,
  tool,
} from '../state'
import { awaited } from '../state/looking'
import { asksSame } from '../state/scenarios'
import { counted, lookTo, settle } from './look_back'

type Awaited = NonNullable<typeof awaited.value>

/** How far the runs are on the way to an iteration. */
type Way = 'on' | 'there' | 'ended' | 'refused'

/** From now on, whichever session is opened. */
export function followAwaited(): void {
  effect(() => {
    const wanted = awaited.value
    untracked(() => {
      stop()
      if (wanted) follow(wanted)
    })
  })
}

let stop = () => {}
/** The notice of what is awaited. */
let told = 0

function follow(wanted: Awaited): void {
  const { look } = wanted
  if (look === null) {
    stop = effect(() => {
      if (isSettled(wanted)) leave(wanted, () => inspect(wanted))
    })
    return
  }
  const isSame = sameRace()
  told = tellAwaited(look)
  stop = effect(() => {
    if (!isSame()) return giveUp(wanted, 'changed')
    const way = wayTo(look)
    if (way === 'there') leave(wanted, () => void arrive(wanted, look).catch(notifyError))
    else if (way === 'ended') giveUp(wanted, 'never')
    else if (way === 'refused') giveUp(wanted, 'refused')
  })
}

/** Whether it is known if the panel that is looked into stays: its planner may be on its way, or one of tomorrow. */
function isSettled({ inspected: there }: Awaited): boolean {
  const panel = panels.value.find(({ id }) => id === there?.panelId)
  return !panel || plannerEntry(panel.setup.planner) !== undefined
}

function tellAwaited(look: number): number {
  return notify('info', t('names.look.awaited', { iteration: numbers.peek().whole.format(look) }), {
    hint: t('names.look.awaitedHint'),
    action: { label: t('names.look.now'), run: runToEnd },
  })
}

/** Ends the waiting after the effect that noticed. */
function leave(wanted: Awaited, then: () => void): void {
  queueMicrotask(() => {
    if (awaited.peek() !== wanted) return
    awaited.value = null
    dismiss(told)
    then()
  })
}

/** Whether the planners still run on the same question as now. */
function sameRace(): () => boolean {
  const of = () => [
    seed.value,
    ...panels.value.flatMap(({ id, setup: { planner, params } }) => [id, planner, params]),
  ]
  const [map, before] = untracked(() => [scenario.value, of()] as const)
  return () => {
    const now = of()
    return isSameMap(map, scenario.value) && now.every((value, at) => value === before[at])
  }
}

const isSameMap = (a: Scenario | null, b: Scenario | null) =>
  a === b || (a !== null && b !== null && asksSame(a, b))

function wayTo(look: number): Way {
  const all = panels.value.map(({ live }) => live.value)
  if (all.some(({ summary, error, crashed }) => !summary && !error && crashed === null)) return 'on'
  const stopped = all.flatMap(({ summary, crashed }) => (crashed === null ? [] : (summary ?? [])))
  const runs = counted.value.filter((summary) => !stopped.includes(summary))
  if (runs.length === 0) return 'refused'
  // One looks back at the very beginning from the first iteration.
  const goal = Math.max(1, look)
  const isThere = runs.some(({ iteration }) => iteration >= goal)
  if (runs.some(({ iteration, status }) => iteration < goal && status === 'running')) return 'on'
  return isThere ? 'there' : 'ended'
}

function giveUp(wanted: Awaited, why: 'changed' | 'never' | 'refused'): void {
  const { whole } = numbers.peek()
  const last = Math.max(0, ...counted.peek().map(({ iteration }) => iteration))
  const words = { iteration: whole.format(wanted.look ?? 0), last: whole.format(last) }
  leave(wanted, () => {
    notify('warning', t(`names.look.${why}`, words), { hint: t(`names.look.${why}Hint`) })
  })
}

async function arrive(wanted: Awaited, look: number): Promise<void> {
  lookTo(look)
  await settle()
  announce(t('names.look.there', { iteration: numbers.peek().whole.format(look) }))
  inspect(wanted)
}

/** Opens the cell, if one was looked into, where its panel is still there. */
function inspect({ inspected: there }: Awaited): void {
  if (!there) return
  if (!panelById(there.panelId)) {
    notify('warning', t('names.look.noPanel'), { hint: t('names.look.noPanelHint') })
    return
  }
  batch(() => {
    tool.value = 'inspect'
    inspected.value = there
  })
}
