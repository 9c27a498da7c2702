/** The lattice of a figure in numbers. */
import type { Lattice } from '@pkg/formicarium'
import { t } from '../i18n/dialogs'
import { NumberField } from '../ui/fields'
import { type Draft, withLattice } from './figure_draft'
import { divided } from './figure_lattice'

/** Most columns and rows, as the engine has them. */
const MOST = 512

const SIDES = ['columns', 'rows'] as const
const PIXELS = ['x0', 'y0', 'dx', 'dy', 'shear_x', 'shear_y'] as const

interface LatticeProps {
  draft: Draft
  onChange: (draft: Draft) => void
}

export function LatticeFields({ draft: { lattice }, onChange }: LatticeProps) {
  const set = (changed: Partial<Lattice>) => onChange(withLattice({ ...lattice, ...changed }))
  const divide = (changed: Partial<Lattice>) => {
    const { columns, rows } = { ...lattice, ...changed }
    onChange(withLattice(divided(lattice, columns, rows)))
  }
  return (
    <fieldset class="field-set figure-lattice">
      <legend>{t('figure.lattice')}</legend>
      <div class="field-row">
        {SIDES.map((side) => (
          <NumberField
            key={side}
            label={t(`figure.fields.${side}`)}
            value={lattice[side]}
            min={1}
            max={MOST}
            step={1}
            nearest
            testId={`figure-${side}`}
            onChange={(value) => divide({ [side]: value })}
          />
        ))}
        {PIXELS.map((key) => (
          <NumberField
            key={key}
            label={t(`figure.fields.${key}`)}
            value={Math.round(1000 * lattice[key]) / 1000}
            min={-1e6}
            max={1e6}
            testId={`figure-${key.replace('_', '-')}`}
            onChange={(value) => set({ [key]: value })}
          />
        ))}
      </div>
      <p class="hint">{t('figure.latticeHint')}</p>
    </fieldset>
  )
}
