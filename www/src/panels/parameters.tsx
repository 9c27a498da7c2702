import type { CatalogEntry, ParamSpec } from '@pkg/formicarium'
import { useComputed } from '@preact/signals'
import { ArrowUp, BookOpen } from 'lucide'
import { t, translated } from '../i18n'
import type { ParamValues } from '../model/messages'
import type { PanelSetup } from '../model/session'
import {
  type Panel,
  panelById,
  panels,
  paramValue,
  plannerEntry,
  selectedPanel,
  setParam,
  setPreset,
  slotColour,
} from '../state'
import { bringIntoSight } from '../ui/bring_into_sight'
import { Button } from '../ui/buttons'
import { Select } from '../ui/fields'
import { lazily } from '../ui/lazily'
import { cardOf, showCard } from '../words/paper_cards'
import { panelTitle, plannerSummary, presetName, runAlike } from '../words/planner_words'
import { ParameterControl } from './parameter_control'

const SECTION_ID = 'parameters'

const Legs = lazily(() => import('./legs').then((legs) => legs.default))

/** Selects a panel and brings its parameters into sight. */
export function showParameters(panelId: number): void {
  selectedPanel.value = panelId
  bringIntoSight(SECTION_ID)
}

export const cardId = (panelId: number) => `panel-${panelId}`

export function Parameters() {
  const selected = panelById(selectedPanel.value ?? -1)
  return (
    <section class="dock-card parameters" id={SECTION_ID} aria-label={t('parameters.title')}>
      <header class="dock-head">
        <h2>{t('parameters.title')}</h2>
        <PanelTabs />
        {selected && <BackToMap panelId={selected.id} />}
      </header>
      {selected ? (
        <Controls key={selected.id} panel={selected} />
      ) : (
        <p class="hint">{t('parameters.none')}</p>
      )}
    </section>
  )
}

/** On a phone the parameters stand a long way below the map they change; elsewhere it is hidden. */
function BackToMap({ panelId }: { panelId: number }) {
  return (
    <span class="back-to-map">
      <Button
        icon={ArrowUp}
        label={t('parameters.toMap')}
        tone="quiet"
        testId="back-to-map"
        onClick={() => bringIntoSight(cardId(panelId))}
      />
    </span>
  )
}

function PanelTabs() {
  return (
    <fieldset class="panel-tabs" aria-label={t('parameters.which')}>
      {panels.value.map(({ id, slot }) => (
        <button
          key={id}
          type="button"
          class="panel-tab"
          aria-pressed={selectedPanel.value === id}
          style={{ '--panel-colour': slotColour(slot) }}
          onClick={() => {
            selectedPanel.value = id
          }}
        >
          <span class="panel-dot" aria-hidden="true" />
          <span class="panel-tab-name">{panelTitle(id)}</span>
        </button>
      ))}
    </fieldset>
  )
}

/** One control for each row of the catalog: nothing about a planner is written here. */
function Controls({ panel }: { panel: Panel }) {
  const { id, setup } = panel
  // The numbers of the run change many times a second; the controls only care for a refusal.
  const refusal = useComputed(() => panelById(id)?.live.value.error ?? null).value
  const touring = useComputed(
    () => (panelById(id)?.live.value.summary?.tour ?? null) !== null,
  ).value
  const entry = plannerEntry(setup.planner)
  if (!entry) return null
  const shown = paramsInForce(entry, setup)
  return (
    <div class="parameter-list">
      <p class="hint">{plannerSummary(entry)}</p>
      <About entry={entry} preset={setup.preset} />
      {touring && <Legs panel={panel} />}
      {entry.presets.length > 0 && (
        <Select
          label={t('parameters.preset')}
          class="preset-field"
          value={setup.preset ?? (Object.keys(setup.params).length > 0 ? 'own' : '')}
          testId="preset"
          options={presetOptions(entry.presets, setup.params)}
          onChange={(name) => {
            if (name !== 'own') setPreset(panel.id, name || null)
          }}
        />
      )}
      <PresetMeaning presets={entry.presets} name={setup.preset} />
      <TwinHint panel={panel} />
      {shown.map((spec) => (
        <ParameterControl
          key={`${setup.planner}.${spec.key}`}
          spec={spec}
          value={paramValue(setup, spec)}
          error={refusal?.field === spec.key ? refusal : null}
          onChange={(value) => setParam(panel.id, spec.key, value)}
        />
      ))}
    </div>
  )
}

/** Parameters that have an effect beside the others' values. */
export function paramsInForce({ params }: CatalogEntry, setup: PanelSetup): ParamSpec[] {
  return params.filter(({ applies_when }) => {
    const governing = params.find(({ key }) => key === applies_when?.key)
    return !applies_when || !governing || applies_when.values.includes(paramValue(setup, governing))
  })
}

/** What its paper claims and what came out, if there is a card about it. */
function About({ entry, preset }: { entry: CatalogEntry; preset: string | null }) {
  const card = cardOf(entry.id, preset)
  if (!card) return null
  return (
    <div class="about">
      <Button
        icon={BookOpen}
        label={t('papers.aboutThis')}
        tone="quiet"
        testId="about-planner"
        onClick={() => showCard(card)}
      />
    </div>
  )
}

/** All panels share a seed, so equal parameters make equal runs. To readers who expect chance this looks like a fault. */
function TwinHint({ panel }: { panel: Panel }) {
  const twin = panels.value.find(
    (other) => other.id !== panel.id && runAlike(other.setup, panel.setup),
  )
  return twin ? (
    <p class="hint" role="status" data-testid="twin-hint">
      {t('parameters.twin', { planner: panelTitle(twin.id) })}
    </p>
  ) : null
}

function PresetMeaning(props: { presets: CatalogEntry['presets']; name: string | null }) {
  const preset = props.presets.find(({ name }) => name === props.name)
  return preset ? (
    <p class="hint">
      {translated(preset.source)}: {translated(preset.meaning)}
    </p>
  ) : null
}

export function presetOptions(presets: CatalogEntry['presets'], params: ParamValues) {
  const named = presets.map((preset) => ({ value: preset.name, label: presetName(preset) }))
  const own = Object.keys(params).length > 0 ? [{ value: 'own', label: t('parameters.own') }] : []
  return [{ value: '', label: t('parameters.defaults') }, ...named, ...own]
}
