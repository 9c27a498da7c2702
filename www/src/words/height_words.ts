/** The height of a cell in words, or what its ground costs. */
import { numbers } from '../i18n'
import { t } from '../i18n/reading'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { groundAt, hasNoData } from '../model/terrain'

/** What is said of a cell on a plane, once there is somebody who knows its ground. */
export const ground: { words?: (scenario: Scenario, cell: Cell) => string | null } = {}

/** Null on plain ground. */
export function heightWords(scenario: Scenario, cell: Cell): string | null {
  if (hasNoData(scenario, cell)) return t('lengths.noData')
  const metres = groundAt(scenario, cell)
  return metres === null
    ? (ground.words?.(scenario, cell) ?? null)
    : t('lengths.metres', { value: numbers.value.metres.format(metres) })
}
