/**
 * What figures look like. They leave the page, where no style sheet follows them: so their colours are written here, the same as
 * styles/tokens.css has for the two themes.
 */
import { COLOURS as OF_RACE } from '../../state/slot_colours'
import { SYMBOLS, type SymbolName } from './point_symbols'

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
  '"Figtree Variable", Inter, "Segoe UI", system-ui, Roboto, "PingFang SC", "Microsoft YaHei", "Noto Sans SC", "Noto Sans CJK SC", "Source Han Sans SC", sans-serif'

/** How one entry is told from the others: by colour, by dashes and by symbol, each of which is enough alone. */
export interface Series {
  label: string
  colour: string
  /** `stroke-dasharray`; none for a whole line. */
  dash: string | undefined
  symbol: SymbolName
}

/** Comparisons may have more entries than the race; these stand on both grounds as well. */
const COLOURS = [...OF_RACE, '#65757d', '#9a6cf0', '#6f9432', '#e0457b'] as const

/** None repeats after more than 25 pixels: a legend shows the whole of it. */
const DASHES = [
  undefined,
  '8 4',
  '2 3',
  '10 3 2 3',
  '18 5',
  '12 3 2 3 2 3',
  '6 3 6 10',
  '2 3 2 3 2 9',
] as const

/**
 * Ten colours, eight dashes, seven symbols, each in its own turn: of the first forty entries no two have two of the three in common. So
 * who sees no colour tells lines by dash and symbol, and the eleventh entry, of the first one's colour, has another dash and symbol.
 */
export function seriesOf(index: number, label: string): Series {
  return {
    label,
    colour: turn(COLOURS, index),
    dash: turn(DASHES, index),
    symbol: turn(SYMBOLS, index),
  }
}

const turn = <T>(all: readonly T[], index: number) => all[index % all.length] as T
