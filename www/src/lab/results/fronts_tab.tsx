/** What runs trade off: which measures, the picture, and what each entry's front comes to. */
import '../../styles/lab_fronts.css'
import type { EngineError } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { t } from '../../i18n/lab'
import type { Analysis, FrontQuestion, MapFronts, Measure } from '../../model/analysis'
import { toEngineError } from '../../model/errors'
import { notifyError } from '../../state'
import { NumberField, Select } from '../../ui/fields'
import { FormError } from '../../ui/form_error'
import { frontsFigure } from '../figures/all_figures'
import type { Plot } from '../figures/figure'
import { FigureCard } from '../figures/figure_card'
import { frontsNow } from '../run/actions'
import { askFronts, frontsAsked } from '../store/fronts_asked'
import { openComparison } from '../store/signals'
import { measureWords } from '../words/numbers'
import { MapChoice, shownMap } from './choices'
import { FrontsTable } from './fronts_table'

const library = signal<Plot | null>(null)
/** What the engine says, and of which question; null while nothing is said. */
const told = signal<{ asked: FrontQuestion; maps: MapFronts[] } | null>(null)
const refused = signal<EngineError | null>(null)
/** The newest answer counts. */
let turn = 0

async function ask(asked: FrontQuestion): Promise<void> {
  const mine = ++turn
  try {
    const maps = await frontsNow(asked)
    if (mine !== turn) return
    refused.value = null
    told.value = maps && { asked, maps }
  } catch (thrown) {
    if (mine === turn) refused.value = toEngineError(thrown)
  }
}

export function FrontsTab({ analysis }: { analysis: Analysis }) {
  const map = shownMap(analysis)
  const asked = frontsAsked.value
  useEffect(() => {
    if (asked) void ask(asked)
  }, [analysis, asked])
  useEffect(() => {
    if (library.peek()) return
    import('../figures/library').then((plot) => {
      library.value = plot
    }, notifyError)
  }, [])
  if (!map || !asked) return null
  const fronts = told.value?.maps[analysis.instances.indexOf(map)]
  const plot = library.value
  return (
    <>
      <div class="result-choices front-choices">
        <MapChoice analysis={analysis} />
        <Measures asked={asked} />
        <Reference asked={asked} fronts={fronts} />
      </div>
      {refused.value && <FormError error={refused.value} />}
      {(!fronts || !plot) && !refused.value && <p role="status">{t('common.working')}</p>}
      {fronts && plot && (
        <>
          <FrontsTable map={map} fronts={fronts} />
          <FigureCard
            figure={frontsFigure}
            plot={plot}
            analysis={analysis}
            map={map}
            logarithmic={false}
            ground="light"
            fronts={fronts}
          />
        </>
      )}
    </>
  )
}

const PLACES = ['first', 'second', 'third'] as const
const NONE = 'none'

/** Two measures or three. Choosing one that is chosen already exchanges the two. */
function Measures({ asked: { measures } }: { asked: FrontQuestion }) {
  const all = openComparison.value?.outline.front_measures ?? []
  const choose = (place: number, to: Measure | typeof NONE) => {
    const chosen: (Measure | undefined)[] = [...measures]
    const other = chosen.indexOf(to as Measure)
    if (other >= 0) chosen[other] = chosen[place]
    chosen[place] = to === NONE ? undefined : to
    // Another measure has another unit: a reference of before means nothing.
    askFronts({ measures: chosen.flatMap((measure) => measure ?? []), reference: null })
  }
  return PLACES.map((name, place) => (
    <Select<Measure | typeof NONE>
      key={name}
      label={t(`lab.fronts.${name}`)}
      value={measures[place] ?? NONE}
      options={[
        ...(name === 'third' ? [{ value: NONE, label: t('lab.fronts.noThird') } as const] : []),
        ...all.map((measure) => ({ value: measure, label: measureWords(measure) })),
      ]}
      onChange={(to) => choose(place, to)}
      testId={`fronts-${name}`}
    />
  ))
}

interface ReferenceProps {
  asked: FrontQuestion
  fronts: MapFronts | undefined
}

/** The engine's reference point, or the reader's own. */
function Reference({ asked, fronts }: ReferenceProps) {
  const { measures, reference } = asked
  const isOwn = Boolean(reference)
  return (
    <fieldset class="fronts-reference">
      <legend class="visually-hidden">{t('lab.fronts.reference')}</legend>
      <label class="toggle">
        <input
          type="checkbox"
          checked={isOwn}
          disabled={!isOwn && !fronts?.reference.length}
          data-testid="fronts-own-reference"
          onChange={(event) => {
            const own = event.currentTarget.checked ? (fronts?.reference ?? null) : null
            askFronts({ measures, reference: own })
          }}
        />
        {t('lab.fronts.ownReference')}
      </label>
      {reference?.map((value, place) => (
        <NumberField
          key={measures[place]}
          label={measureWords(measures[place] ?? 'length')}
          value={value}
          min={-1e9}
          max={1e9}
          onChange={(to) => {
            if (Number.isFinite(to)) {
              askFronts({ measures, reference: reference.map((v, i) => (i === place ? to : v)) })
            }
          }}
          testId={`fronts-reference-${place}`}
        />
      ))}
    </fieldset>
  )
}
