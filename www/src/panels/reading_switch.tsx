/** By which reading of its paper a planner is run: one press sets the preset. */
import type { CatalogEntry } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import '../styles/radio_segments.css'
import '../styles/reading_switch.css'
import { translated } from '../i18n'
import { addReadingsWords, t } from '../i18n/readings'
import { readingNow, readingsOf } from '../model/readings'
import type { PanelSetup } from '../model/session'
import { noteSwap, type Panel, panelById, setPreset, setValues } from '../state'
import { RadioSegments } from '../ui/radio_segments'

interface ReadingSwitchProps {
  entry: CatalogEntry
  setup: Values
  /** For screen readers, where there are several switches. */
  label?: string
  testId: string
  /** The name of a preset; null: the defaults. */
  onChoose: (preset: string | null) => void
}

type Values = Pick<PanelSetup, 'preset' | 'params'>

/** Nothing of a planner that has no readings. */
export function ReadingSwitch({ entry, setup, label, testId, onChoose }: ReadingSwitchProps) {
  const line = useId()
  const offered = readingsOf(entry)
  if (offered.length === 0) return null
  const choose = (reading: string) => {
    const preset = offered.find((each) => each.reading === reading)?.preset
    onChoose(preset?.name ?? null)
  }
  return (
    <div class="reading-switch">
      <span class="field-label" aria-hidden="true">
        {t('readings.title')}
      </span>
      <RadioSegments
        label={label ?? t('readings.title')}
        value={readingNow(entry, setup)}
        options={offered.map(({ reading }) => ({
          value: reading,
          label: t(`readings.names.${reading}`),
        }))}
        testId={testId}
        describedBy={line}
        onChange={choose}
      />
      <p class="hint" id={line} data-testid={`${testId}-meaning`}>
        {meaning(entry, setup)}
      </p>
    </div>
  )
}

/** What the chosen reading means. */
function meaning(entry: CatalogEntry, setup: Values): string {
  const now = readingNow(entry, setup)
  const chosen = readingsOf(entry).find(({ reading }) => reading === now)
  if (!chosen) {
    const isOwn = setup.preset === null && Object.keys(setup.params).length > 0
    return t(isOwn ? 'readings.own' : 'readings.noReading')
  }
  const { preset } = chosen
  if (!preset) return t('readings.defaults')
  const { source, meaning } = preset
  return t('parameters.presetIs', { source: translated(source), meaning: translated(meaning) })
}

/** On a panel, where it is one step to undo. */
function PanelReading({ panel, entry }: { panel: Panel; entry: CatalogEntry }) {
  const { id, setup } = panel
  return (
    <ReadingSwitch
      entry={entry}
      setup={setup}
      testId="reading"
      onChoose={(preset) => {
        const { planner, preset: chosen, params } = setup
        setPreset(id, preset)
        noteSwap(exchangeValues(id, planner, { preset: chosen, params }))
      }}
    />
  )
}

/** Exchanges a panel's values with others, as long as it has the planner that they are of. */
function exchangeValues(id: number, planner: string, other: Values) {
  let others = other
  return () => {
    const now = panelById(id)?.setup
    if (now?.planner !== planner) return
    setValues(id, others)
    others = { preset: now.preset, params: now.params }
  }
}

/** With its words. */
export async function fetchPanelReading() {
  await addReadingsWords()
  return PanelReading
}
