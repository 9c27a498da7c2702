/** In which unit lengths are shown, above all results: the reader's choice where all maps have a scale. */
import { t } from '../../i18n/lab'
import { lengthUnit, setLengthUnit } from '../../state/length_unit'
import { Labelled, Segmented } from '../../ui/fields'
import { scaledMaps } from '../store/metres'

export function UnitLine() {
  if (scaledMaps.value === 'none') return null
  if (scaledMaps.value === 'some')
    return (
      <p class="hint results-unit" data-testid="lengths-unit">
        {t('lab.results.unit.some')}
      </p>
    )
  return (
    <div class="result-choices results-unit" data-testid="lengths-unit">
      <Labelled label={t('lab.results.unit.label')}>
        <Segmented
          label={t('lab.results.unit.label')}
          value={lengthUnit.value}
          options={(['metres', 'cells'] as const).map((value) => ({
            value,
            label: t(`lab.results.unit.${value}`),
            testId: `lab-lengths-${value}`,
          }))}
          onChange={setLengthUnit}
        />
      </Labelled>
    </div>
  )
}
