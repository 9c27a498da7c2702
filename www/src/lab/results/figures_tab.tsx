/** All figures of the chosen map, and of all maps together. */
import { signal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import type { Ground } from '../../figures/look'
import { t } from '../../i18n/lab'
import type { Analysis } from '../../model/analysis'
import { notifyError } from '../../state'
import { Labelled, Segmented } from '../../ui/fields'
import { figuresOf } from '../figures/all_figures'
import type { Plot } from '../figures/figure'
import { FigureCard } from '../figures/figure_card'
import { AxisChoice, MapChoice, shownMap } from './choices'

const library = signal<Plot | null>(null)
const logarithmic = signal(true)
/** Papers are printed on white. */
const ground = signal<Ground>('light')

export function FiguresTab({ analysis }: { analysis: Analysis }) {
  const map = shownMap(analysis)
  useEffect(() => {
    if (library.peek()) return
    import('../figures/library').then((plot) => {
      library.value = plot
    }, notifyError)
  }, [])
  if (!map) return null
  const plot = library.value
  return (
    <>
      <div class="result-choices">
        <MapChoice analysis={analysis} />
        <AxisChoice />
        <label class="toggle">
          <input
            type="checkbox"
            checked={logarithmic.value}
            data-testid="figures-log"
            onChange={(event) => {
              logarithmic.value = event.currentTarget.checked
            }}
          />
          {t('lab.results.logarithmic')}
        </label>
        <GroundChoice />
      </div>
      {!plot && <p role="status">{t('common.working')}</p>}
      {plot && (
        <div class="figures" data-testid="figures">
          {figuresOf(analysis).map((figure) => (
            <FigureCard
              key={figure.id}
              figure={figure}
              plot={plot}
              analysis={analysis}
              map={map}
              logarithmic={logarithmic.value}
              ground={ground.value}
            />
          ))}
        </div>
      )}
    </>
  )
}

function GroundChoice() {
  return (
    <Labelled label={t('lab.results.ground')}>
      <Segmented
        label={t('lab.results.ground')}
        value={ground.value}
        options={(['light', 'dark'] as const).map((value) => ({
          value,
          label: t(`lab.results.grounds.${value}`),
          testId: `ground-${value}`,
        }))}
        onChange={(value) => {
          ground.value = value
        }}
      />
    </Labelled>
  )
}
