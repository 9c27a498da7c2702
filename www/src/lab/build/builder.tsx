/** A form for a new comparison: maps × entries × seeds, and the budget of a run. */
import { Play, RotateCcw } from 'lucide'
import { useEffect, useId, useState } from 'preact/hooks'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { LONGEST } from '../../model/names'
import { catalog, scenario, wholeEngine } from '../../state'
import { Button } from '../../ui/buttons'
import { FormError } from '../../ui/form_error'
import { startComparison } from '../run/actions'
import { alikeWords } from '../run/count_words'
import { refusedFiles, withImportedFiles } from '../store/imported_files'
import { BudgetFields } from './budget'
import { compose } from './compose_document'
import { entries, maps, refusal, runs, runsAlike, seeds, takeRace, title } from './draft'
import { Entries } from './entries'
import { titleOf } from './labels'
import { Maps } from './maps'
import { NoteField } from './note_field'
import { isShownElsewhere } from './refusals'
import { restoreDraft } from './stored_draft'

export function Builder() {
  const ready = scenario.value !== null && catalog.value !== null
  useEffect(() => {
    if (ready) void restoreDraft()
  }, [ready])
  return (
    <section class="lab-card builder" aria-label={t('lab.build.title')} data-testid="builder">
      <header class="builder-head">
        <h3>{t('lab.build.title')}</h3>
        <span data-tip={t('lab.build.takeRaceHint')}>
          <Button
            icon={RotateCcw}
            label={t('lab.build.takeRace')}
            tone="quiet"
            testId="take-race"
            onClick={takeRace}
          />
        </span>
      </header>
      <Maps />
      <Entries />
      <BudgetFields />
      <TitleField />
      <NoteField />
      <StartBar />
    </section>
  )
}

function TitleField() {
  const id = useId()
  return (
    <div class="builder-row">
      <label class="field-label" for={id}>
        {t('lab.build.name')}
      </label>
      <input
        id={id}
        class="input title-input"
        type="text"
        maxLength={LONGEST.title}
        value={title.value ?? ''}
        placeholder={titleOf()}
        data-testid="study-title"
        onInput={(event) => {
          title.value = event.currentTarget.value || null
        }}
      />
    </div>
  )
}

function StartBar() {
  const [busy, setBusy] = useState(false)
  const count = runs.value
  const start = async () => {
    setBusy(true)
    refusal.value = null
    try {
      await startComparison(await withImportedFiles(await compose()))
    } catch (error) {
      refusal.value = error
    }
    setBusy(false)
  }
  return (
    <footer class="start-bar">
      <p class="hint" data-testid="run-count">
        {count > 0 ? sum() : ''}
      </p>
      {refusedFiles.value.length > 0 && (
        <p class="hint" role="status" data-testid="not-joined">
          {t('lab.imported.notJoined', { count: refusedFiles.value.length })}
        </p>
      )}
      {refusal.value !== null && !isShownElsewhere(refusal.value) && (
        <FormError error={refusal.value} />
      )}
      <Button
        icon={Play}
        label={t('lab.build.run', { runs: runWords() })}
        tone="primary"
        testId="lab-start"
        busy={busy}
        disabled={count === 0 || wholeEngine.value === 'fetching'}
        onClick={() => void start()}
      />
    </footer>
  )
}

function sum(): string {
  const all = t('lab.build.count', {
    maps: t('lab.build.mapCount', { count: maps.value.length }),
    planners: t('lab.build.plannerCount', { count: entries.value.length }),
    seeds: t('lab.build.seedCount', { count: seeds.value.count }),
    runs: runWords(),
  })
  return [all, alikeWords(runsAlike.value)].filter((part) => part !== '').join(' · ')
}

/** i18next picks the plural by the number; what is shown is grouped. */
function runWords(): string {
  const words = t('lab.build.runCount', { count: runs.value })
  return words.replace(String(runs.value), numbers.value.whole.format(runs.value))
}
