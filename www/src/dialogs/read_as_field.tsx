/** A picture is read by its pixels, or by the cells of the grid that it shows. */
import type { Lattice } from '@pkg/formicarium'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { Labelled, Segmented } from '../ui/fields'

export type ReadAs = 'picture' | 'figure'

interface ReadAsProps {
  as: ReadAs
  /** A lattice that was found, if any. */
  found: Lattice | null
  onChange: (as: ReadAs) => void
}

export function ReadAsField({ as, found, onChange }: ReadAsProps) {
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
        {found && t(as === 'picture' ? 'figure.offer' : 'figure.found', shown(found))}
      </p>
    </div>
  )
}

const shown = ({ columns, rows }: Lattice) => ({
  columns: numbers.value.whole.format(columns),
  rows: numbers.value.whole.format(rows),
})
