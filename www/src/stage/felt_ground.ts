/**
 * What the ground of the map on show costs, as the robot feels it, and where that has no room. Fetched with the legend; cells are told with
 * it from then on.
 */
import { computed, effect, signal } from '@preact/signals'
import { lateTools } from '../engine/late_tools'
import { numbers } from '../i18n'
import { addWeightWords, t } from '../i18n/weights'
import type { Cell } from '../model/cell'
import type { LayerEnds } from '../model/messages'
import type { Scenario } from '../model/session'
import { key } from '../model/settle_ends'
import type { FeltCells } from '../model/tool_calls'
import { DEAREST, mostFactor, PLAIN } from '../model/weights'
import { scenario } from '../state'
import { ground } from '../words/height_words'
import { offerRoom } from './robot_room'

/** Long enough that a drag does not ask for every cell it crosses. */
const SETTLE_MS = 150

const answered = signal<{ of: Scenario; felt: FeltCells } | null>(null)

/** The last that is known: walls that are being drawn do not take the legend away. */
const felt = computed((): FeltCells | null => {
  const now = scenario.value
  if (!now) return null
  return now.spec.robot ? (answered.value?.felt ?? null) : feltByPoint(now)
})

const feltByPoint = ({ cells, factors }: Scenario): FeltCells => ({ blocked: cells, factors })

/** The factors that the least and the greatest colour stand for; null on plain ground with room everywhere. */
export const weightEnds = computed((): LayerEnds | null =>
  felt.value?.factors || hasNarrow.value ? [PLAIN, DEAREST] : null,
)
/** Whether any ground costs more than its length, and whether some more than the greatest colour tells. */
export const isDear = computed(() => !!felt.value?.factors)
export const isDearer = computed(() => mostOf(felt.value) > DEAREST)
/** Whether there are free cells in which the robot does not fit. */
export const hasNarrow = computed(() => {
  const [now, blocked] = [scenario.value, felt.value?.blocked]
  return !!now?.spec.robot && !!blocked?.some((cell, i) => cell === 1 && now.cells[i] === 0)
})

const mostOf = (known: FeltCells | null) =>
  known ? mostFactor({ cells: known.blocked, factors: known.factors }) : PLAIN

let timer = 0
effect(() => {
  const now = scenario.value
  clearTimeout(timer)
  if (!now?.spec.robot || answered.peek()?.of === now) return
  timer = window.setTimeout(() => void ask(now), SETTLE_MS)
})

/** What cannot be used is said where runs are refused. */
async function ask(of: Scenario): Promise<void> {
  const told = await lateTools.feltMap(of).catch(() => null)
  if (scenario.peek() === of) answered.value = told && { of, felt: told }
}

/** What the ground of a free cell costs; null where that is its length, and while it is not known. */
function groundWords(now: Scenario, cell: Cell): string | null {
  const known = now.spec.robot ? answered.value : { of: now, felt: feltByPoint(now) }
  const at = key(cell, now.spec.width)
  if (known?.of !== now || now.cells[at] === 1) return null
  if (known.felt.blocked[at] === 1) return t('weights.cellNarrow')
  const factor = known.felt.factors?.[at] ?? PLAIN
  if (factor === PLAIN) return null
  return t('weights.cellFactor', { factor: numbers.value.metres.format(factor) })
}

export async function startGroundWords(): Promise<void> {
  await addWeightWords()
  if (ground.words) return
  ground.words = groundWords
  offerRoom()
}
