/** The cell under pointer or cursor and how high it lies, in a corner of a terrain's stage. Screen readers hear it as they move. */
import type { ReadonlySignal } from '@preact/signals'
import { t } from '../i18n'
import { scenario } from '../state'
import { heightWords } from '../words/height_words'
import type { Cursor } from './panel_view'

export function CellReadout({ cursor }: { cursor: ReadonlySignal<Cursor | null> }) {
  const now = scenario.value
  const cell = cursor.value?.cell
  const height = now && cell ? heightWords(now, cell) : null
  if (!cell || height === null) return null
  return (
    <p class="cell-readout" aria-hidden="true" data-testid="cell-readout">
      <span>{t('relief.cell', { x: cell[0], y: cell[1] })}</span> <b>{height}</b>
    </p>
  )
}
