/**
 * What figures look like. They leave the page, where no style sheet follows them: so their colours are written here, the same as
 * styles/tokens.css has for the two themes.
 */
import { slotColour } from '../../state'
import type { SymbolName } from './symbols'

export type Ground = 'light' | 'dark'

export interface Look {
  background: string
  text: string
  muted: string
  line: string
  bad: string
}

export const LOOKS: Record<Ground, Look> = {
  light: {
    background: '#ffffff',
    text: '#14211d',
    muted: '#53625c',
    line: '#dde3e0',
    bad: '#a3271b',
  },
  dark: {
    background: '#141c1a',
    text: '#e6eeea',
    muted: '#98a8a1',
    line: '#2f3d3a',
    bad: '#ff9b8f',
  },
}

export const FONT =
  '"Figtree Variable", Inter, "Segoe UI", system-ui, Roboto, "Noto Sans SC", "PingFang SC", "Microsoft YaHei", sans-serif'

/** How one entry is told from the others: by colour, by dashes and by symbol, each of which is enough alone. */
export interface Series {
  label: string
  colour: string
  /** `stroke-dasharray`; none for a whole line. */
  dash: string | undefined
  symbol: SymbolName
}

/** Diamonds are kept for published numbers. */
const SYMBOLS: SymbolName[] = [
  'circle',
  'square',
  'triangle',
  'falling',
  'star',
  'hexagon',
  'cross',
]
/** The race has so many colours; comparisons may have more entries. */
const SLOTS = 6
const MORE_COLOURS = ['#8c6d1f', '#6d7f8b', '#7a5bd0', '#a33b3b']
const DASHES = [undefined, '7 3', '2 3', '10 3 2 3', '4 2', '12 4 2 4 2 4', '1 3 6 3'] as const

export function seriesOf(index: number, label: string): Series {
  return {
    label,
    colour: MORE_COLOURS[index - SLOTS] ?? slotColour(index),
    dash: DASHES[index % DASHES.length],
    symbol: SYMBOLS[index % SYMBOLS.length] ?? 'circle',
  }
}
