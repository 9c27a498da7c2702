/** The selected part of the map: taken up, moved, copied, turned and laid down again. Each of these is one step to undo. */
import { computed, effect, signal } from '@preact/signals'
import { t } from '../i18n/editor'
import { type Block, blockOf, freeBlock, layBlock, turnBlock } from '../model/block'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import type { Area } from '../model/spans'
import { isQuarter, type Turn, turnMap, turnRefused } from '../model/turn'
import { fitView } from '../model/viewpoint'
import { newGesture } from '../stage/brush'
import { announce, commit, notify, scenario, tool } from '../state'

export const selection = signal<Area | null>(null)
const clipboard = signal<Block | null>(null)
export const canPaste = computed(() => clipboard.value !== null)

/** What has been taken up, as long as nothing else changes the map: moved on, it uncovers again what it had covered. */
interface Lifted {
  base: Scenario
  block: Block
  at: Cell
  gesture: number
  result: Scenario
}
let lifted: Lifted | null = null

effect(() => {
  const map = scenario.value?.spec
  const area = selection.peek()
  const fits = area && map && area.x + area.width <= map.width && area.y + area.height <= map.height
  if (tool.value !== 'select' || !fits) selection.value = null
})

export function select(area: Area): void {
  selection.value = area
  announce(t('editor.selected', { ...area }))
}

export function selectAll(): void {
  const map = scenario.peek()?.spec
  if (map) select({ x: 0, y: 0, width: map.width, height: map.height })
}

export function unselect(): void {
  selection.value = null
  announce(t('editor.unselected'))
}

/** Takes the selection up: out of the map, or as a copy of it. */
export function lift(now: Scenario, area: Area, copies: boolean): Lifted {
  const goesOn = lifted?.result === now && lifted.at[0] === area.x && lifted.at[1] === area.y
  if (lifted && goesOn && !copies) return lifted
  const block = blockOf(now, area)
  const at: Cell = [area.x, area.y]
  const base = copies ? now : layBlock(now, freeBlock(area), at).map
  return { base, block, at, gesture: newGesture(), result: now }
}

/** Lays it down with its upper left cell at `at`, or as near to it as the map reaches. */
export function lay(taken: Lifted, at: Cell): void {
  const { spec } = taken.base
  const { width, height } = taken.block
  const place: Cell = [within(at[0], spec.width - width), within(at[1], spec.height - height)]
  const laid = layBlock(taken.base, taken.block, place)
  lifted = { ...taken, at: place, result: laid.map }
  commit(laid.map, taken.gesture)
  // Of a turned one as much as lies on the map.
  const shown = { width: Math.min(width, spec.width), height: Math.min(height, spec.height) }
  selection.value = { x: place[0], y: place[1], ...shown }
}

const within = (value: number, most: number) => Math.max(0, Math.min(value, most))

/** Once it lies where it stays. */
export function tellLaid(said: 'editor.movedTo' | 'editor.pasted'): void {
  if (lifted === null) return
  const { base, block, at } = lifted
  announce(t(said, { x: at[0], y: at[1] }))
  if (layBlock(base, block, at).keptFree > 0)
    notify('info', t('editor.keptFree'), { hint: t('editor.keptFreeHint') })
}

export function nudge([dx, dy]: Cell): void {
  const [now, area] = [scenario.peek(), selection.peek()]
  if (!now || !area) return
  lay(lift(now, area, false), [area.x + dx, area.y + dy])
  tellLaid('editor.movedTo')
}

export function copy(): void {
  const [now, area] = [scenario.peek(), selection.peek()]
  if (!now || !area) return
  clipboard.value = blockOf(now, area)
  announce(t('editor.copied', { ...area }))
}

export function cut(): void {
  const area = selection.peek()
  copy()
  if (!area || !emptied(area)) return
  announce(t('editor.cut', { ...area }))
}

/** Where the selection is, or at this cell. */
export function paste(cell: Cell | null): void {
  const [now, block, area] = [scenario.peek(), clipboard.peek(), selection.peek()]
  if (!now || !block) return
  tool.value = 'select'
  const at: Cell = area ? [area.x, area.y] : (cell ?? [0, 0])
  lay({ base: now, block, at, gesture: newGesture(), result: now }, at)
  tellLaid('editor.pasted')
}

export function free(): void {
  const area = selection.peek()
  if (area && emptied(area)) announce(t('editor.freed'))
}

function emptied(area: Area): boolean {
  const now = scenario.peek()
  if (!now) return false
  commit(layBlock(now, freeBlock(area), [area.x, area.y]).map)
  return true
}

/** The selection about its middle, or without one the whole map. */
export function turn(which: Turn): void {
  const [now, area] = [scenario.peek(), selection.peek()]
  if (!now) return
  if (area) turnSelection(now, area, which)
  else if (turnRefused(now, which)) {
    notify('warning', t('editor.slices'), { hint: t('editor.slicesHint') })
    return
  } else turnAll(now, which)
  announce(t(`editor.turned.${which}`))
}

function turnSelection(now: Scenario, area: Area, which: Turn): void {
  const taken = lift(now, area, false)
  const block = turnBlock(taken.block, which)
  const x = area.x + Math.floor((area.width - block.width) / 2)
  const y = area.y + Math.floor((area.height - block.height) / 2)
  lay({ ...taken, block, gesture: newGesture() }, [x, y])
  tellLaid('editor.movedTo')
}

function turnAll(now: Scenario, which: Turn): void {
  commit(turnMap(now, which))
  if (isQuarter(which)) fitView()
  else if (now.spec.world) notify('info', t('editor.noWorld'), { hint: t('editor.noWorldHint') })
}
