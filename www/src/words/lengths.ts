/** How lengths and places are told: in cells, until `words/metres.ts` is here and the map has a scale. */
import { signal } from '@preact/signals'
import { numbers } from '../i18n'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'

interface MetreWords {
  /** Of a length in cells; null where the reader wants cells. */
  length: ((cells: number) => string) | null
  /** How high a cell lies and where, each in words. */
  place(now: Scenario, cell: Cell): string[]
}

/** Null until they are there. */
export const metreWords = signal<MetreWords | null>(null)

/** A length in cells as it is shown. */
export const lengthShown = (cells: number): string =>
  (metreWords.value?.length ?? numbers.value.length.format)(cells)

export const placeShown = (now: Scenario, cell: Cell): string[] =>
  metreWords.value?.place(now, cell) ?? []
