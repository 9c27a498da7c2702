/** The height of a cell in words. */
import { numbers, t } from '../i18n'
import type { Cell } from '../maps/edit'
import { groundAt, hasNoData } from '../maps/terrain'
import type { Scenario } from '../session'

/** Null on a plane. */
export function heightWords(scenario: Scenario, cell: Cell): string | null {
  if (hasNoData(scenario, cell)) return t('relief.noData')
  const metres = groundAt(scenario, cell)
  return metres === null
    ? null
    : t('relief.height', { height: numbers.value.metres.format(metres) })
}
