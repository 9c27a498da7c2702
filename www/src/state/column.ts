/** The column beside the maps, a sheet on a compact screen: whether it is open and how wide. Both are kept on this device. */
import { computed, signal } from '@preact/signals'
import { recall, remember } from './appearance'
import { compact } from './screen'

const OPEN_KEY = 'formicarium.column'
const WIDTH_KEY = 'formicarium.column-width'

const columnShown = signal(recall(OPEN_KEY) !== 'closed')
/** A sheet covers maps: nobody gets it without asking. */
const sheetShown = signal(false)

export const columnOpen = computed(() => (compact.value ? sheetShown.value : columnShown.value))

/** CSS pixels; null for the width that the styles give it. */
export const columnWidth = signal(Number(recall(WIDTH_KEY)) || null)

/** A part of the column that somebody wants to see: set until it has come into sight, for it may have to be fetched first. */
export const soughtPart = signal<'parameters' | 'goals' | null>(null)

export function openColumn(open: boolean): void {
  if (compact.peek()) sheetShown.value = open
  else {
    columnShown.value = open
    remember(OPEN_KEY, open ? 'open' : 'closed')
  }
}

/** Opens the column, and brings a part of it into sight. */
export function seek(part: 'parameters' | 'goals'): void {
  openColumn(true)
  soughtPart.value = part
}

export function toggleColumn(): void {
  openColumn(!columnOpen.peek())
}

/** The styles keep it within what the window allows. */
export function setColumnWidth(width: number | null): void {
  columnWidth.value = width
  remember(WIDTH_KEY, width === null ? '' : String(width))
}
