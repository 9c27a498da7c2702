import type { CatalogEntry, EngineError, ParamSpec } from '@pkg/formicarium'
import { type Signal, useComputed, useSignal, useSignalEffect } from '@preact/signals'
import { BookOpen, ChevronDown, ChevronRight, RotateCcw } from 'lucide'
import { translated } from '../i18n'
import { t } from '../i18n/column'
import type { ParamValues } from '../model/messages'
import {
  baseSet,
  type Panel,
  panelById,
  panels,
  paramValue,
  plannerEntry,
  selectedPanel,
  setParam,
  setPreset,
  slotColour,
  soughtPart,
} from '../state'
import { bringIntoSight } from '../ui/bring_into_sight'
import { Button } from '../ui/buttons'
import { Select } from '../ui/fields'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { fold, Section } from '../ui/section'
import { cardOf, showCard } from '../words/paper_cards'
import { panelTitle, plannerSummary, presetName, runAlike } from '../words/planner_words'
import { inGroups, matches, paramsInForce } from './parameter_groups'
import type { ParameterRowProps } from './parameter_row'
import { ParameterRows } from './parameter_rows'

const SECTION_ID = 'parameters'

/** Keeps its place until it is there. */
const ReadingPlace = () => <div class="reading-place" />
const PanelReading = lazily(
  () => import('./reading_switch').then((part) => part.fetchPanelReading()),
  ReadingPlace,
)
const Legs = lazily(() => import('./legs').then((legs) => legs.default))

export function Parameters() {
  const selected = panelById(selectedPanel.value ?? -1)
  useSignalEffect(() => {
    if (soughtPart.value !== 'parameters') return
    soughtPart.value = null
    fold(SECTION_ID, false)
    bringIntoSight(SECTION_ID)
  })
  return (
    <Section id={SECTION_ID} title={t('parameters.title')} class="parameters">
      <PanelTabs />
      {selected ? (
        <Controls key={selected.id} panel={selected} />
      ) : (
        <p class="hint">{t('parameters.none')}</p>
      )}
    </Section>
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
          <span class="name">{panelTitle(id)}</span>
        </button>
      ))}
    </fieldset>
  )
}

/** One row for each row of the catalog: nothing about a planner is written here. */
function Controls({ panel }: { panel: Panel }) {
  const { id, setup } = panel
  // The numbers of the run change many times a second; the controls only care for a refusal.
  const refusal = useComputed(() => panelById(id)?.live.value.error ?? null).value
  const touring = useComputed(
    () => (panelById(id)?.live.value.summary?.tour ?? null) !== null,
  ).value
  const entry = plannerEntry(setup.planner)
  if (!entry) return null
  return (
    <div class="parameter-list">
      <p class="hint">{plannerSummary(entry)}</p>
      <About entry={entry} preset={setup.preset} />
      {touring && <Legs panel={panel} />}
      {entry.presets.some(({ reading }) => reading) && <PanelReading panel={panel} entry={entry} />}
      {entry.params.length > 0 && <SetField panel={panel} entry={entry} />}
      <PresetMeaning presets={entry.presets} name={setup.preset} />
      <TwinHint panel={panel} />
      <AllRows key={setup.planner} panel={panel} entry={entry} refusal={refusal} />
    </div>
  )
}

/** Which set the values come from, and the way back to it. */
function SetField({ panel, entry }: { panel: Panel; entry: CatalogEntry }) {
  const { id, setup } = panel
  const own = setup.preset === null && Object.keys(setup.params).length > 0
  return (
    <div class="set-field">
      {entry.presets.length > 0 && (
        <Select
          label={t('parameters.preset')}
          class="preset-field"
          value={setup.preset ?? (own ? 'own' : '')}
          testId="preset"
          options={presetOptions(entry.presets, setup.params)}
          onChange={(name) => {
            if (name !== 'own') setPreset(id, name || null)
          }}
        />
      )}
      <Button
        icon={RotateCcw}
        label={t('parameters.reset')}
        tone="quiet"
        testId="reset-parameters"
        disabled={!own}
        onClick={() => setPreset(id, baseSet(panel))}
      />
    </div>
  )
}

interface AllRowsProps {
  panel: Panel
  entry: CatalogEntry
  refusal: EngineError | null
}

/** More rows than this can be searched. */
const MANY = 8

function AllRows({ panel, entry, refusal }: AllRowsProps) {
  const sought = useSignal('')
  const unfolded = useSignal(false)
  const rows = paramsInForce(entry, panel.setup).map((spec) => rowOf(panel, entry, spec, refusal))
  const { first, rest } = inGroups(rows.map(({ spec }) => spec))
  const among = (specs: ParamSpec[]) =>
    specs.flatMap((spec) => rows.filter((row) => row.spec === spec))
  if (sought.value.trim() !== '') {
    const found = rows.filter(({ spec }) => matches(spec, sought.value))
    return (
      <>
        <SearchField sought={sought} />
        <ParameterRows rows={found} />
        {found.length === 0 && <p class="hint">{t('parameters.notFound')}</p>}
      </>
    )
  }
  const changed = among(rest).filter(({ value, base }) => value !== base).length
  const open = unfolded.value || rest.some(({ key }) => key === refusal?.field)
  return (
    <>
      {rows.length > MANY && <SearchField sought={sought} />}
      <ParameterRows rows={among(first)} />
      {rest.length > 0 && (
        <button
          type="button"
          class="fold more-parameters"
          aria-expanded={open}
          data-testid="more-parameters"
          onClick={() => {
            unfolded.value = !open
          }}
        >
          <Icon icon={open ? ChevronDown : ChevronRight} size={14} />
          {t('parameters.more', { count: rest.length })}
          {changed > 0 && <span class="hint">{t('parameters.changed', { count: changed })}</span>}
        </button>
      )}
      {open && <ParameterRows rows={among(rest)} />}
    </>
  )
}

function SearchField({ sought }: { sought: Signal<string> }) {
  return (
    <input
      class="input parameter-search"
      type="search"
      value={sought.value}
      placeholder={t('parameters.search')}
      aria-label={t('parameters.search')}
      data-testid="search-parameters"
      onInput={(event) => {
        sought.value = event.currentTarget.value
      }}
      onKeyDown={(event) => {
        if (event.key === 'Escape') sought.value = ''
      }}
    />
  )
}

function rowOf(
  panel: Panel,
  entry: CatalogEntry,
  spec: ParamSpec,
  refusal: EngineError | null,
): ParameterRowProps {
  const set = entry.presets.find(({ name }) => name === baseSet(panel))
  return {
    spec,
    value: paramValue(panel.setup, spec),
    base: set?.values[spec.key] ?? spec.default,
    error: refusal?.field === spec.key ? refusal : null,
    onChange: (value) => setParam(panel.id, spec.key, value),
  }
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
  // The switch above says what a reading is.
  return preset && !preset.reading ? (
    <p class="hint">
      {t('parameters.presetIs', {
        source: translated(preset.source),
        meaning: translated(preset.meaning),
      })}
    </p>
  ) : null
}

export function presetOptions(presets: CatalogEntry['presets'], params: ParamValues) {
  const named = presets.map((preset) => ({ value: preset.name, label: presetName(preset) }))
  const own = Object.keys(params).length > 0 ? [{ value: 'own', label: t('parameters.own') }] : []
  return [{ value: '', label: t('parameters.defaults') }, ...named, ...own]
}
