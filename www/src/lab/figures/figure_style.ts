/** How the entries of a comparison are told apart in figures and tables. */
import type { Series } from '../../figures/look'
import { SYMBOLS } from '../../figures/point_symbols'
import { COLOURS as OF_RACE } from '../../state/slot_colours'

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
