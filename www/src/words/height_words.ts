/** The height of a cell in words. */
import { numbers } from '../i18n'
import { t } from '../i18n/reading'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { groundAt, hasNoData } from '../model/terrain'

/** Null on a plane. */
export function heightWords(scenario: Scenario, cell: Cell): string | null {
  if (hasNoData(scenario, cell)) return t('lengths.noData')
  const metres = groundAt(scenario, cell)
  return metres === null
    ? null
    : t('lengths.metres', { value: numbers.value.metres.format(metres) })
}
