/** The fields of a film, a moving picture or slides. */
import { MOST_SECONDS, RATES, SIDE, SIZES, secondsOf, speedFor } from '../film/settings'
import { t } from '../i18n/film'
import { layerChoices } from '../model/session'
import { panels, plannerEntry } from '../state'
import { NumberField, Segmented, Select } from '../ui/fields'
import { panelTitle } from '../words/planner_words'
import { type Draft, filmOf, LIMITS, rounded, withOffer, withSide, withUnit } from './film_draft'

interface FieldsProps {
  draft: Draft
  onChange: (draft: Draft) => void
}

export function FilmFields(props: FieldsProps) {
  return (
    <div class="field-row film-fields">
      <SizeFields {...props} />
      {props.draft.what === 'film' ? <TimeFields {...props} /> : <StepFields {...props} />}
      <LookFields {...props} />
    </div>
  )
}

function SizeFields({ draft, onChange }: FieldsProps) {
  const offers = SIZES.map(({ width, height }, i) => ({
    value: String(i),
    label: `${width} × ${height}`,
  }))
  const side = (name: 'width' | 'height') => (
    <NumberField
      label={t(`film.${name}`)}
      value={draft[name]}
      min={SIDE.least}
      max={SIDE.most}
      step={2}
      nearest
      testId={`film-${name}`}
      onChange={(value) => onChange(withSide(draft, { [name]: value }))}
    />
  )
  return (
    <>
      <Select
        label={t('film.size')}
        value={String(draft.offer)}
        testId="film-size"
        options={[...offers, { value: '-1', label: t('film.own') }]}
        onChange={(value) => onChange(withOffer(draft, Number(value)))}
      />
      {draft.offer < 0 && side('width')}
      {draft.offer < 0 && side('height')}
    </>
  )
}

function TimeFields({ draft, onChange }: FieldsProps) {
  const { rate, unit, last } = draft
  return (
    <>
      <Select
        label={t('film.unit')}
        value={unit}
        testId="film-unit"
        options={(['iteration', 'move'] as const).map((value) => ({
          value,
          label: t(`film.units.${value}`),
        }))}
        onChange={(next) => onChange(withUnit(draft, next))}
      />
      <LastField draft={draft} onChange={onChange} />
      <NumberField
        label={t(`film.speed.${unit}`)}
        value={rounded(draft.perSecond)}
        min={0.1}
        max={LIMITS.last.most}
        testId="film-speed"
        onChange={(value) => onChange({ ...draft, perSecond: inTime(draft, value) })}
      />
      <NumberField
        label={t('film.seconds')}
        value={Math.round(10 * secondsOf(filmOf(draft))) / 10}
        min={1}
        max={MOST_SECONDS}
        testId="film-seconds"
        onChange={(value) => {
          const seconds = Math.min(MOST_SECONDS, Math.max(1, value))
          onChange({ ...draft, perSecond: speedFor(seconds, { rate, last }) })
        }}
      />
      <Select
        label={t('film.rate')}
        value={String(rate)}
        testId="film-rate"
        options={RATES.map((value) => ({ value: String(value), label: String(value) }))}
        onChange={(value) => {
          const next = RATES.find((each) => String(each) === value) ?? rate
          onChange({ ...draft, rate: next })
        }}
      />
    </>
  )
}

/** No film is longer than the longest that is offered. */
function inTime({ rate, last }: Draft, perSecond: number): number {
  const slowest = speedFor(MOST_SECONDS, { rate, last })
  return Math.max(0.1, slowest, perSecond)
}

function LastField({ draft, onChange }: FieldsProps) {
  const unit = draft.what === 'film' ? draft.unit : 'iteration'
  return (
    <NumberField
      label={t(`film.last.${unit}`)}
      value={draft.last}
      min={LIMITS.last.least}
      max={LIMITS.last.most}
      step={1}
      nearest
      testId="film-last"
      onChange={(last) =>
        onChange({ ...draft, last, perSecond: inTime({ ...draft, last }, draft.perSecond) })
      }
    />
  )
}

function StepFields({ draft, onChange }: FieldsProps) {
  return (
    <>
      <LastField draft={draft} onChange={onChange} />
      <NumberField
        label={t('film.steps')}
        value={draft.steps}
        min={LIMITS.steps.least}
        max={LIMITS.steps.most}
        step={1}
        nearest
        testId="film-count"
        onChange={(steps) => onChange({ ...draft, steps })}
      />
      <Select
        label={t('film.spread')}
        value={draft.spread}
        testId="film-spread"
        options={(['even', 'better'] as const).map((value) => ({
          value,
          label: t(`film.spreads.${value}`),
        }))}
        onChange={(spread) => onChange({ ...draft, spread })}
      />
    </>
  )
}

function LookFields({ draft, onChange }: FieldsProps) {
  const offered = new Set(
    panels.value.flatMap(({ setup }) => plannerEntry(setup.planner)?.layers ?? []),
  )
  const one = panels.value.map(({ id }) => ({ value: String(id), label: panelTitle(id) }))
  return (
    <>
      <Select
        label={t('film.layer')}
        value={draft.layer}
        testId="film-layer"
        options={layerChoices()
          .filter((id) => id === draft.layer || id === 'none' || offered.has(id))
          .map((id) => ({ value: id, label: t(`view.layers.${id}`) }))}
        onChange={(layer) => onChange({ ...draft, layer })}
      />
      <Select
        label={t('film.panels')}
        value={String(draft.whose)}
        testId="film-panels"
        options={[{ value: 'all', label: t('film.all') }, ...one]}
        onChange={(value) => onChange({ ...draft, whose: value === 'all' ? 'all' : Number(value) })}
      />
      <Segmented
        label={t('film.theme')}
        value={draft.theme}
        options={(['light', 'dark'] as const).map((value) => ({
          value,
          label: t(`film.themes.${value}`),
          testId: `film-${value}`,
        }))}
        onChange={(theme) => onChange({ ...draft, theme })}
      />
    </>
  )
}
