/** What all tabs have in common: which map is shown, and what effort is counted in. */
import { signal } from '@preact/signals'
import { CircleAlert } from 'lucide'
import { t } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { Labelled, Segmented, Select } from '../../ui/fields'
import { Icon } from '../../ui/icon'
import { seriesOf } from '../figures/figure_style'
import { AXES, axis } from '../store/signals'

const chosenMap = signal<string | null>(null)

/** The chosen map; the first one where it is not there. */
export function shownMap({ instances }: Analysis): MapAnalysis | undefined {
  return instances.find(({ id }) => id === chosenMap.value) ?? instances[0]
}

export function chooseMap(id: string): void {
  chosenMap.value = id
}

/** Not shown while there is only one. */
export function MapChoice({ analysis }: { analysis: Analysis }) {
  if (analysis.instances.length < 2) return null
  return (
    <Select
      label={t('lab.results.map')}
      value={shownMap(analysis)?.id ?? ''}
      options={analysis.instances.map(({ id, name }) => ({ value: id, label: name || id }))}
      onChange={chooseMap}
      testId="results-map"
    />
  )
}

export function AxisChoice() {
  return (
    <Labelled label={t('lab.results.axis')}>
      <Segmented
        label={t('lab.results.axis')}
        value={axis.value}
        options={AXES.map((value) => ({
          value,
          label: t(`lab.results.axesShort.${value}`),
          testId: `axis-${value}`,
        }))}
        onChange={(value) => {
          axis.value = value
        }}
      />
    </Labelled>
  )
}

/** A heading for what is about one map, with what stands about it in the question. */
export function MapHead({ map }: { map: MapAnalysis }) {
  return (
    <header class="result-map">
      <h3>{map.name || map.id}</h3>
      {map.note && <p class="hint">{map.note}</p>}
    </header>
  )
}

/** What was not run has no colour of its own: it is in no figure. */
export const dotColour = ({ origin }: EntryAnalysis, index: number) =>
  origin === 'missing' ? 'var(--line-strong)' : seriesOf(index, '').colour

interface AlertProps {
  words: string
  /** Of what it holds, where that is more than one thing. */
  items?: string[]
}

/** An impossible value, in red. */
export function Alert({ words, items = [] }: AlertProps) {
  return (
    <div class="result-impossible" data-testid="impossible">
      <Icon icon={CircleAlert} size={18} />
      <div>
        <p>{words}</p>
        {items.length > 0 && (
          <ul>
            {items.map((item) => (
              <li key={item}>{item}</li>
            ))}
          </ul>
        )}
      </div>
    </div>
  )
}
