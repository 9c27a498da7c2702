/**
 * The cell under pointer or cursor, how high it lies and where in the world, in a corner of the stage of a map that knows either.
 * Screen readers hear it as they move.
 */
import type { ReadonlySignal } from '@preact/signals'
import { t } from '../i18n'
import { scenario } from '../state'
import { placeShown } from '../words/lengths'
import type { Cursor } from './panel_view'

export function CellReadout({ cursor }: { cursor: ReadonlySignal<Cursor | null> }) {
  const now = scenario.value
  const cell = cursor.value?.cell
  if (!now || !cell) return null
  const words = placeShown(now, cell)
  if (words.length === 0) return null
  return (
    <p class="cell-readout" aria-hidden="true" data-testid="cell-readout">
      <span>{t('relief.cell', { x: cell[0], y: cell[1] })}</span> <b>{words.join(' · ')}</b>
    </p>
  )
}
