/** Start and goals as a table: where each lies; of goals also what they are called, and how urgent they are. */
import type { EngineError, Goal } from '@pkg/formicarium'
import { useSignal, useSignalEffect } from '@preact/signals'
import { MapPinPlus, X } from 'lucide'
import { useEffect } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/column'
import { errorText } from '../i18n/errors'
import type { Cell as MapCell } from '../model/cell'
import { limits } from '../model/facts'
import { goalName, goalWeight } from '../model/goals'
import { scaleOf } from '../model/world'
import { activeGoal, applyEdit, goalsShown, scenario, soughtPart, tool } from '../state'
import { bringIntoSight } from '../ui/bring_into_sight'
import { Button, CloseButton, IconButton } from '../ui/buttons'
import { placeShown } from '../words/lengths'
import { placeError, quantityError, readPlace } from './goal_input'
import { GOALS_ID } from './goals_shown'

const QUANTITIES = ['area', 'strength', 'danger'] as const
const SYMBOLS = { area: 's', strength: 'w', danger: 'a' } as const

export default function GoalsCard() {
  const spec = scenario.value?.spec
  const goals = spec?.goals ?? []
  const hasScale = spec !== undefined && scaleOf(spec) !== null
  // One message at a time: for the field that was refused last.
  const refusal = useSignal<EngineError | null>(null)
  useSignalEffect(() => {
    if (soughtPart.value !== 'goals') return
    soughtPart.value = null
    bringIntoSight(GOALS_ID)
  })
  const refuse = (error: EngineError | null) => {
    refusal.value = error
  }
  return (
    <section
      class="column-card goals"
      id={GOALS_ID}
      aria-label={t('goals.title')}
      data-testid="goals"
    >
      <header class="column-head">
        <h2>{t('goals.count', { count: goals.length })}</h2>
        <AddGoal full={goals.length >= limits.max_goals} />
        {goals.length === 1 && (
          <CloseButton
            label={t('goals.hide')}
            onClick={() => {
              goalsShown.value = false
            }}
          />
        )}
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="table-scroll" tabIndex={0} aria-label={t('goals.title')}>
        <table class="goal-table">
          <Head />
          <tbody>
            <StartRow refuse={refuse} />
            {goals.map((goal, index) => (
              <Row key={index} goal={goal} index={index} refuse={refuse} />
            ))}
          </tbody>
        </table>
      </section>
      {refusal.value && <Refusal error={refusal.value} />}
      <p class="hint goal-hint">
        {t('goals.hint')}
        {hasScale && <> {t('goals.metresHint')}</>}
      </p>
    </section>
  )
}

function AddGoal({ full }: { full: boolean }) {
  return (
    <Button
      icon={MapPinPlus}
      label={t('goals.add')}
      tone="quiet"
      testId="goals-add"
      disabled={full}
      onClick={() => {
        tool.value = 'add-goal'
      }}
    />
  )
}

function Head() {
  return (
    <thead>
      <tr>
        <th scope="col">{t('goals.name')}</th>
        {QUANTITIES.map((key) => (
          <th key={key} scope="col" title={t(`goals.hints.${key}`)}>
            {t(`goals.${key}`)} <i>{SYMBOLS[key]}</i>
          </th>
        ))}
        <th scope="col" title={t('goals.hints.weight')}>
          {t('goals.weight')} <i>b</i>
        </th>
        <td />
      </tr>
    </thead>
  )
}

interface RefusingProps {
  refuse: (error: EngineError | null) => void
}

function StartRow({ refuse }: RefusingProps) {
  const spec = scenario.value?.spec
  if (!spec) return null
  return (
    <tr>
      <th scope="row">{t('goals.start')}</th>
      <Place
        end="start"
        at={spec.start}
        label={t('goals.placeOfStart')}
        testId="start-place"
        refuse={refuse}
      />
    </tr>
  )
}

interface RowProps extends RefusingProps {
  goal: Goal
  index: number
}

function Row({ goal, index, refuse }: RowProps) {
  const spec = scenario.value?.spec
  if (!spec) return null
  const name = goalName(spec, index)
  const change = (changed: Partial<Goal>) => {
    refuse(null)
    applyEdit({ kind: 'change-goal', index, change: changed })
    return true
  }
  const row = { 'data-active': activeGoal.value === index, onFocusIn: () => takeUp(index) }
  return (
    <>
      <tr {...row}>
        <td>
          <Cell
            class="goal-name"
            label={t('goals.nameOf', { name })}
            value={goal.name}
            testId={`goal-name-${index + 1}`}
            accept={(text) => change({ name: text.slice(0, 200) })}
          />
        </td>
        {QUANTITIES.map((key) => (
          <td key={key}>
            <Cell
              label={t('goals.quantityOf', { what: t(`goals.${key}`), name })}
              value={String(goal[key])}
              testId={`goal-${key}-${index + 1}`}
              numeric
              accept={(text) => {
                const error = quantityError(goal, key, text)
                if (!error) return change({ [key]: Number(text) })
                refuse(error)
                return false
              }}
            />
          </td>
        ))}
        <td class="goal-weight" data-testid={`goal-weight-${index + 1}`}>
          {numbers.value.weight.format(goalWeight(goal))}
        </td>
        <td>
          <IconButton
            icon={X}
            label={t('goals.remove', { name })}
            tone="quiet"
            size={16}
            disabled={spec.goals.length < 2}
            testId={`goal-remove-${index + 1}`}
            onClick={() => applyEdit({ kind: 'remove-goal', index })}
          />
        </td>
      </tr>
      <tr {...row} class="goal-second">
        <th scope="row">{t('goals.place')}</th>
        <Place
          end={index}
          at={goal.at}
          label={t('goals.placeOf', { name })}
          testId={`goal-place-${index + 1}`}
          refuse={refuse}
        />
      </tr>
    </>
  )
}

interface PlaceProps extends RefusingProps {
  /** The start, or the index of a goal. */
  end: 'start' | number
  at: MapCell
  label: string
  testId: string
}

/** As column and row; beneath in metres, on a map that has a scale. */
function Place({ end, at, label, testId, refuse }: PlaceProps) {
  const now = scenario.value
  if (!now) return null
  const accept = (text: string) => {
    const error = placeError(now.spec, end, text)
    const to = readPlace(now.spec, text)
    refuse(error)
    if (error || !to) return false
    applyEdit(end === 'start' ? { kind: 'start', at: to } : { kind: 'goal', index: end, at: to })
    return true
  }
  const where = placeShown(now, at).join(' · ')
  return (
    <td class="goal-at" colSpan={5}>
      <Cell
        class="goal-place"
        label={label}
        value={at.join(', ')}
        testId={testId}
        accept={accept}
      />
      {where !== '' && <span class="goal-where">{where}</span>}
    </td>
  )
}

/** The goal tool moves the goal that is being worked on. */
function takeUp(index: number): void {
  activeGoal.value = index
}

interface CellProps {
  label: string
  value: string
  testId: string
  numeric?: boolean
  class?: string
  /** False when the text cannot be used: it stays, marked, until it is mended or left with Escape. */
  accept: (text: string) => boolean
}

function Cell({ label, value, testId, numeric, accept, class: extra = '' }: CellProps) {
  // What was typed and refused; a change from elsewhere replaces it.
  const draft = useSignal<string | null>(null)
  useEffect(() => {
    draft.value = null
  }, [value])
  const refused = draft.value !== null
  return (
    <input
      class={`input goal-input ${extra}`}
      value={draft.value ?? value}
      inputMode={numeric ? 'decimal' : undefined}
      aria-label={label}
      aria-invalid={refused}
      aria-describedby={refused ? 'goal-error' : undefined}
      spellcheck={false}
      autocomplete="off"
      data-testid={testId}
      onChange={({ currentTarget }) => {
        const text = currentTarget.value.trim()
        draft.value = accept(text) ? null : text
      }}
      onKeyDown={({ key, currentTarget }) => {
        if (key !== 'Escape') return
        currentTarget.value = value
        draft.value = null
        accept(value)
      }}
    />
  )
}

function Refusal({ error }: { error: EngineError }) {
  return (
    <p class="field-error" id="goal-error" role="alert">
      {errorText(error)}
    </p>
  )
}
