/** A picture is read by its pixels, or by the cells of the grid that it shows. */
import type { Lattice } from '@pkg/formicarium'
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
    if (as === 'picture') return t('figure.offer', sidesOf(found))
    const now = draft?.lattice ?? found
    return t(isSame(now, found) ? 'figure.found' : 'figure.changed', sidesOf(now))
  }
  return as === 'figure' && draft ? t('figure.none') : ''
}

const sidesOf = ({ columns, rows }: Lattice) => ({ columns: whole(columns), rows: whole(rows) })
const isSame = (a: Lattice, b: Lattice) =>
  (Object.keys(a) as (keyof Lattice)[]).every((key) => a[key] === b[key])
const whole = (count: number) => numbers.value.whole.format(count)
