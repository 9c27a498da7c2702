/** The drive on show: a robot in a worker of its own, which the race knows nothing of. Any change of what it depends on begins it anew. */
import type { Drive, DriveState, EngineError, ParamSpec } from '@pkg/formicarium'
import { batch, computed, effect, signal } from '@preact/signals'
import { type DriveBox, newDriveBox } from '../engine/drive_box'
import type { Cell } from '../model/cell'
import type { Driven } from '../model/drive_calls'
import { toEngineError } from '../model/errors'
import type { ParamValues, RunSetup } from '../model/messages'
import { lessonMode, panelById, panels, scenario, seed, selectedPanel } from '../state'

/** Steps a second that can be chosen. */
export const PACES = [2, 5, 10, 30, 100] as const
/** Of a frame so much is the worker's. */
const SLICE_MS = 25
/** What is drawn or typed at once begins one drive. */
const SETTLE_MS = 120

/** What the steps so far have come to. */
export interface Tally {
  waits: number
  plans: number
  expansions: number
  antMoves: number
}

const NOTHING: Tally = { waits: 0, plans: 0, expansions: 0, antMoves: 0 }

/** Whose planner drives: that of the panel that was selected when the drive was opened, until another is chosen. */
const chosen = signal<number | null>(null)
export const drivingPanel = computed(() => panelById(chosen.value ?? -1) ?? panels.value[0] ?? null)
export const choosePanel = (id: number) => {
  chosen.value = id
}

/** Null while the robot is being put on the map, and where it cannot be. */
export const standing = signal<DriveState | null>(null)
/** The cells on which it has stood, its start first. */
export const driven = signal<readonly Cell[]>([])
export const tally = signal(NOTHING)
/** What the drive has come to; null before its end, and while the best in advance is searched for. */
export const summary = signal<Drive | null>(null)
export const running = signal(false)
export const pace = signal<number>(10)
/** Why there is no drive, or none any more. */
export const failure = signal<EngineError | null>(null)

/** How the robot drives, as rows; empty until the engine has told. */
export const rows = signal<ParamSpec[]>([])
/** The values that differ from the rows' defaults. */
export const driving = signal<ParamValues>({})

export const isOver = computed(() => standing.value?.end != null)

let box: DriveBox | null = null
/** Answers to what was asked in an earlier turn are dropped. */
let turn = 0
let isSummingUp = false

/** The worker of the drive; a failed one is replaced. */
export function driveBox(): DriveBox {
  if (box === null || box.dead) box = newDriveBox()
  return box
}

/** What a robot begins with; null without a map or a planner. */
export function setupNow(): RunSetup | null {
  const [now, panel] = [scenario.value, drivingPanel.value]
  if (!now || !panel) return null
  const { planner, params } = panel.setup
  const { spec, cells, heights, factors } = now
  return { spec, cells, heights, factors, planner, params, seed: seed.value }
}

/** Keeps a drive ready for as long as the mode lasts; what is returned ends it, and gives its worker back. */
export function keepDriving(): () => void {
  chosen.value = selectedPanel.peek()
  void driveBox()
    .call('driveParams')
    .then((all) => {
      rows.value = all
    }, failed)
  let timer = 0
  const stop = effect(() => {
    const [setup, values] = [setupNow(), driving.value]
    clearTimeout(timer)
    forget()
    if (setup) timer = window.setTimeout(() => void begin(setup, values), SETTLE_MS)
  })
  return () => {
    stop()
    clearTimeout(timer)
    forget()
    endWorker()
  }
}

function endWorker(): void {
  box?.terminate()
  box = null
  isSummingUp = false
}

export function closeDrive(): void {
  lessonMode.value = null
}

function forget(): void {
  turn++
  // Nobody waits for a search that nobody wants any more.
  if (isSummingUp) endWorker()
  batch(() => {
    running.value = false
    standing.value = null
    driven.value = []
    tally.value = NOTHING
    summary.value = null
    failure.value = null
  })
}

async function begin(setup: RunSetup, values: ParamValues): Promise<void> {
  await answer(driveBox().call('startDrive', setup, values))
}

/** Back to the start, at rest. */
export async function restart(): Promise<void> {
  const setup = setupNow()
  forget()
  if (setup) await begin(setup, driving.peek())
}

export async function step(): Promise<void> {
  running.value = false
  if (standing.peek() && !isOver.peek()) await answer(driveBox().call('advanceDrive', 1, SLICE_MS))
}

/** Drives on, or pauses; after its end from the start. */
export async function toggle(): Promise<void> {
  if (running.peek()) {
    running.value = false
    return
  }
  if (isOver.peek()) await restart()
  if (!standing.peek()) return
  running.value = true
  await drive(turn)
}

async function drive(mine: number): Promise<void> {
  let last = performance.now()
  let due = 0
  while (mine === turn && running.peek() && !isOver.peek()) {
    const now = await nextFrame()
    due = Math.min(pace.peek(), due + ((now - last) * pace.peek()) / 1000)
    last = now
    const count = Math.floor(due)
    if (count === 0 || mine !== turn || !running.peek()) continue
    due -= count
    await answer(driveBox().call('advanceDrive', count, SLICE_MS))
  }
  if (mine === turn) running.value = false
}

const nextFrame = () => new Promise<number>(requestAnimationFrame)

async function answer(asked: Promise<Driven>): Promise<void> {
  const mine = turn
  try {
    const now = await asked
    if (mine !== turn) return
    takeIn(now)
    if (now.state.end) await sumUp(mine)
  } catch (thrown) {
    if (mine === turn) failed(thrown)
  }
}

function takeIn({ state, steps }: Driven): void {
  const now = { ...tally.peek() }
  const way = driven.peek().length > 0 ? [...driven.peek()] : [state.last.at]
  for (const { did, at, planned } of steps) {
    if (did === 'wait') now.waits++
    else way.push(at)
    if (!planned) continue
    now.plans++
    now.expansions += planned.cell_expansions
    now.antMoves += planned.ant_moves
  }
  batch(() => {
    standing.value = state
    driven.value = way
    tally.value = now
  })
}

async function sumUp(mine: number): Promise<void> {
  if (summary.peek()) return
  isSummingUp = true
  const found = await driveBox()
    .call('sumUpDrive')
    .finally(() => {
      if (mine === turn) isSummingUp = false
    })
  if (mine === turn) summary.value = found
}

function failed(thrown: unknown): void {
  batch(() => {
    running.value = false
    failure.value = toEngineError(thrown)
  })
}
