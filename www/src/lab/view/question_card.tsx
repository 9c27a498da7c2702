/** What the open comparison asks, folded, with buttons to change it or run it again. */
import { PenLine, RotateCcw } from 'lucide'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { notifyError } from '../../state'
import { embedding } from '../../state/embedding'
import { Button } from '../../ui/buttons'
import { ImportedResults } from '../build/imported_results'
import { labelOfPlanner } from '../build/labels'
import { takeAsTemplate } from '../build/template'
import {
  closeComparison,
  type OpenComparison,
  openComparison,
  phase,
  runAgain,
} from '../run/actions'
import { shownComparison } from '../store/shown_comparison'

export function QuestionCard() {
  const now = openComparison.value
  if (!now) return null
  return (
    <section class="lab-card asked" aria-label={t('lab.run.asked')}>
      <Question />
      {phase.value !== 'running' && <Again of={now} />}
    </section>
  )
}

/** Kept apart from the run bar: a click meant for "Pause" that comes too late must not start the runs again. */
function Again({ of }: { of: OpenComparison }) {
  const change = async () => {
    await takeAsTemplate(of)
    closeComparison()
  }
  return (
    <div class="asked-actions">
      {!embedding && (
        <Button
          icon={PenLine}
          label={t('lab.run.change')}
          testId="lab-change"
          onClick={() => change().catch(notifyError)}
        />
      )}
      <Button
        icon={RotateCcw}
        label={t('lab.run.again')}
        testId="lab-again"
        onClick={() => runAgain().catch(notifyError)}
      />
    </div>
  )
}

function Question() {
  const now = shownComparison.value
  if (!now) return null
  const { asks, paper, seeds, budget, instances, entries } = now.question
  const { whole } = numbers.value
  return (
    <details data-testid="asked">
      <summary>
        <h3>{t('lab.run.asked')}</h3>
        <span class="hint">
          {t('lab.build.mapCount', { count: instances.length })}
          {' · '}
          {t('lab.build.plannerCount', { count: entries.length })}
          {' · '}
          {t('lab.run.seedsAre', { count: seeds.count, from: seeds.from })}
          {' · '}
          {budget
            ? t('lab.run.budgetIs', {
                amount: whole.format(budget.amount),
                axis: t(`lab.build.budgets.${budget.axis}`).toLowerCase(),
              })
            : t('lab.run.noBudget')}
        </span>
      </summary>
      <p class="asks">{asks}</p>
      {paper && <p class="hint">{paper}</p>}
      <div class="asked-lists">
        <ul>
          {instances.map(({ id, note }, at) => (
            <li key={id}>
              <strong>{now.maps[at]?.name || id}</strong>{' '}
              <span class="hint">{note || sizeOf(now.maps[at])}</span>
            </li>
          ))}
        </ul>
        <ul>
          {entries.map(({ id, label, planner, preset, set, missing, results }) => (
            <li key={id}>
              <strong>{results ? t('lab.matrix.fromElsewhere', { name: label }) : label}</strong>{' '}
              <span class="hint">
                {planner ? labelOfPlanner(planner, preset ?? null, set ?? {}) : missing || results}
              </span>
            </li>
          ))}
        </ul>
      </div>
      <ImportedResults
        maps={now.question.instances.map(({ id }, at) => ({ id, name: now.maps[at]?.name || id }))}
      />
    </details>
  )
}

const sizeOf = (map: { width: number; height: number } | undefined) =>
  map ? t('lab.build.size', { width: map.width, height: map.height }) : ''
