/** A picture is read by its pixels, or by the cells of the grid that it shows. */
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { Labelled, Segmented } from '../ui/fields'
import type { FigureState } from './figure_state'

export type ReadAs = 'picture' | 'figure'

interface ReadAsProps {
  as: ReadAs
  figure: FigureState
  onChange: (as: ReadAs) => void
}

export function ReadAsField({ as, figure, onChange }: ReadAsProps) {
  return (
    <div class="read-as">
      <Labelled label={t('figure.readAs')}>
        <Segmented
          label={t('figure.readAs')}
          value={as}
          options={(['picture', 'figure'] as const).map((one) => ({
            value: one,
            label: t(`figure.as.${one}`),
            testId: `map-as-${one}`,
          }))}
          onChange={onChange}
        />
      </Labelled>
      <p class="hint read-as-note" role="status" data-testid="figure-offer">
        {noteOn(as, figure)}
      </p>
    </div>
  )
}

/** What came of looking for a lattice. */
function noteOn(as: ReadAs, { found, draft }: FigureState): string {
  if (found) {
    const { columns, rows } = found
    const sides = { columns: whole(columns), rows: whole(rows) }
    return t(as === 'picture' ? 'figure.offer' : 'figure.found', sides)
  }
  return as === 'figure' && draft ? t('figure.none') : ''
}

const whole = (count: number) => numbers.value.whole.format(count)
