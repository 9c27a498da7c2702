/** The height of a cell in words. */
import { numbers, t } from '../i18n'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { groundAt, hasNoData } from '../model/terrain'

/** Null on a plane. */
export function heightWords(scenario: Scenario, cell: Cell): string | null {
  if (hasNoData(scenario, cell)) return t('relief.noData')
  const metres = groundAt(scenario, cell)
  return metres === null
    ? null
    : t('relief.height', { height: numbers.value.metres.format(metres) })
}
