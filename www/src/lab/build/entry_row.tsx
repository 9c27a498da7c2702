/** One entry of the draft: its name in tables, its preset and parameters, and the actions on it. */
import type { CatalogEntry, EngineError } from '@pkg/formicarium'
import { Copy, Scissors, X } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { t as tOfReadings } from '../../i18n/readings'
import type { DraftEntry } from '../../model/draft'
import { LONGEST } from '../../model/names'
import { paramsInForce } from '../../panels/parameter_groups'
import { ParameterRows } from '../../panels/parameter_rows'
import { presetOptions } from '../../panels/parameters'
import { ReadingSwitch } from '../../panels/reading_switch'
import { notifyError, paramValue, plannerEntry } from '../../state'
import { Button, IconButton } from '../../ui/buttons'
import { Select } from '../../ui/fields'
import { FormError } from '../../ui/form_error'
import { plannerName } from '../../words/planner_words'
import { seriesOf } from '../figures/figure_style'
import { ablate, isOfAblation } from './ablation'
import { changeEntry, copyEntry, removeEntry } from './draft'
import { labelOf } from './labels'
import { refusalOfEntry } from './refusals'
import { whyNotHere } from './why_not'

export function EntryRow({ entry, place }: { entry: DraftEntry; place: number }) {
  const known = plannerEntry(entry.planner)
  const name = labelOf(entry)
  const refused = refusalOfEntry(entry)
  const why = known ? whyNotHere(known) : null
  return (
    <li
      class="draft-entry"
      style={{ '--panel-colour': seriesOf(place, '').colour }}
      data-testid={`entry-${place + 1}`}
    >
      <div class="entry-head">
        <span class="panel-dot" aria-hidden="true" />
        <input
          class="input entry-label"
          type="text"
          maxLength={LONGEST.label}
          value={entry.label ?? ''}
          placeholder={name}
          aria-label={t('lab.build.label')}
          data-testid="entry-label"
          onInput={({ currentTarget }) =>
            changeEntry(entry.key, { label: currentTarget.value || null })
          }
        />
        {entry.label !== null && (
          <span class="entry-planner hint">{known ? plannerName(known) : entry.planner}</span>
        )}
        <span class="entry-tools">
          {known && known.components.length > 0 && !isOfAblation(entry) && (
            <span data-tip={t('lab.build.ablateHint')}>
              <Button
                icon={Scissors}
                label={t('lab.build.ablate')}
                tone="quiet"
                testId="ablate"
                onClick={() => ablate(entry).catch(notifyError)}
              />
            </span>
          )}
          <IconButton
            icon={Copy}
            label={t('lab.build.copy', { name })}
            tone="quiet"
            testId="entry-copy"
            onClick={() => copyEntry(entry.key)}
          />
          <IconButton
            icon={X}
            label={t('lab.build.remove', { name })}
            tone="quiet"
            testId="entry-remove"
            onClick={() => removeEntry(entry.key)}
          />
        </span>
      </div>
      {why && <p class="remark">{why}</p>}
      {refused && !isOfParameter(refused, known) && <FormError error={refused} />}
      {known && (
        <ReadingSwitch
          entry={known}
          setup={entry}
          label={tOfReadings('readings.of', { name })}
          testId="entry-reading"
          onChoose={(preset) => choosePreset(entry.key, known, preset)}
        />
      )}
      {known && known.params.length > 0 && (
        <Values entry={entry} known={known} name={name} refused={refused} />
      )}
    </li>
  )
}

const isOfParameter = (error: EngineError, known: CatalogEntry | undefined) =>
  known?.params.some(({ key }) => key === error.field) ?? false

interface ValuesProps {
  entry: DraftEntry
  known: CatalogEntry
  name: string
  refused: EngineError | null
}

/** Folded: most comparisons take planners as they are. */
function Values({ entry, known, name, refused }: ValuesProps) {
  const isRefused = refused !== null && isOfParameter(refused, known)
  const [unfolded, unfold] = useState(false)
  const open = unfolded || isRefused
  const { planner, preset, params, label } = entry
  const setup = { planner, preset, params, label, result: null }
  const count = Object.keys(params).length
  return (
    <details
      class="entry-values"
      open={open}
      onToggle={(event) => unfold(event.currentTarget.open)}
    >
      <summary aria-label={t('lab.build.parametersOf', { name })}>
        {t('lab.build.parameters')}{' '}
        <span class="hint">
          {count > 0 ? t('lab.build.changed', { count }) : t('lab.build.defaults')}
        </span>
      </summary>
      {open && (
        <div class="parameter-list">
          {known.presets.length > 0 && (
            <Select
              label={t('lab.build.preset')}
              class="preset-field"
              value={preset ?? (count > 0 ? 'own' : '')}
              options={presetOptions(known.presets, params)}
              testId="entry-preset"
              onChange={(chosen) => {
                if (chosen !== 'own') choosePreset(entry.key, known, chosen)
              }}
            />
          )}
          <ParameterRows
            rows={paramsInForce(known, setup).map((spec) => ({
              spec,
              value: paramValue(setup, spec),
              base:
                known.presets.find(({ name }) => name === preset)?.values[spec.key] ?? spec.default,
              error: refused?.field === spec.key ? refused : null,
              onChange: (value) => {
                const { [spec.key]: _, ...others } = params
                const changed = value === spec.default ? others : { ...others, [spec.key]: value }
                changeEntry(entry.key, { params: changed, preset: null })
              },
            }))}
          />
        </div>
      )}
    </details>
  )
}

function choosePreset(key: number, known: CatalogEntry, name: string | null): void {
  const preset = known.presets.find((each) => each.name === name)
  changeEntry(key, { preset: preset?.name ?? null, params: { ...preset?.values } })
}
