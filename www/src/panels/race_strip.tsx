import type { Objective, ScenarioSpec, SliceRules } from '@pkg/formicarium'
import { TriangleAlert } from 'lucide'
import { numbers, t } from '../i18n'
import { describeNotice } from '../i18n/errors'
import { objectives, referenceRefusal, references, scenario, scenarioNotices } from '../state'
import { show } from '../state/dialogs'
import { Icon } from '../ui/icon'
import { referenceValue } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { objectiveWord } from '../words/objective_words'
import { showGoals } from './goals_shown'

/** What is being raced for, in one line. The target comes last, so that nothing moves when it becomes known. */
export function RaceStrip() {
  return (
    <section class="race-strip" aria-label={t('race.region')}>
      <GoalCount />
      <TerrainModel />
      <Target />
      <ScenarioRemarks />
    </section>
  )
}

/** The way to the table of goals, where there are several. */
function GoalCount() {
  const count = scenario.value?.spec.goals.length ?? 1
  if (count < 2) return null
  return (
    <button type="button" class="link" data-testid="goal-count" onClick={showGoals}>
      {t('goals.count', { count })}
    </button>
  )
}

/** How one moves on the terrain, and the way to where that is set. */
function TerrainModel() {
  const spec = scenario.value?.spec
  if (!spec?.terrain) return null
  const { slices } = spec.terrain
  return (
    <button
      type="button"
      class="link"
      data-testid="terrain-model"
      title={slices ? t('terrain.ends', endLevels(slices)) : t('terrain.change')}
      onClick={() => show('resize')}
    >
      {slices ? slicesWords(slices) : surfaceWords(spec)}
    </button>
  )
}

/** The levels of the ends are seen nowhere else on the flat map. */
function slicesWords(slices: SliceRules): string {
  const level = numbers.value.metres.format(slices.level)
  return t('terrain.slicesNow', { levels: slices.levels, level, ...endLevels(slices) })
}

const endLevels = ({ start_level, goal_level }: SliceRules) => ({
  start: start_level,
  goal: goal_level,
})

/** A limit of slope may be the only reason why there is no path. */
function surfaceWords({ movement: { moves }, terrain }: ScenarioSpec): string {
  const slope = terrain?.max_slope ?? 90
  if (slope >= 90) return t('terrain.surfaceNow', { moves })
  return t('terrain.slopeNow', { moves, slope: numbers.value.metres.format(slope) })
}

/** The reference for every objective of the panels. */
function Target() {
  if (!scenario.value) return null
  const shown = objectives.value
  if (shown.some((objective) => references.value[objective]?.kind === 'no-path')) {
    const several = scenario.value.spec.goals.length > 1
    return (
      <span class="target remark" data-testid="optimum" data-value={Number.POSITIVE_INFINITY}>
        {t(several ? 'race.goalUnreachable' : 'race.unreachable')}
      </span>
    )
  }
  return (
    <>
      {shown.map((objective, index) => (
        <Best
          key={objective}
          objective={objective}
          testId={`optimum${index > 0 ? index + 1 : ''}`}
        />
      ))}
    </>
  )
}

function Best({ objective, testId }: { objective: Objective; testId: string }) {
  const reference = references.value[objective] ?? null
  const value = referenceValue(reference)
  const open = referenceRefusal.value === null ? 'race.proving' : 'race.refused'
  const what = t(`race.best.${objectiveWord(objective)}`)
  return (
    <span class="target" data-testid={testId} data-objective={objective} data-value={value ?? ''}>
      {value !== null
        ? t('race.target', { what, value: lengthShown(value) })
        : t(reference === null ? open : 'race.unknown', { what })}
      {reference?.kind === 'unproven' && <span class="unproven"> {t('gap.notProven')}</span>}
    </span>
  )
}

/** The engine's notices, without the one that there is no path: the target says so already. */
function ScenarioRemarks() {
  const refusal = referenceRefusal.value
  const told = scenarioNotices.value.filter(({ kind }) => kind !== 'unreachable')
  const isTold = refusal === null || told.some(({ kind }) => kind === refusal.kind)
  const remarks = isTold ? told : [...told, refusal]
  return (
    <>
      {remarks.map((notice) => (
        <Remark key={notice.kind} words={describeNotice(notice)} />
      ))}
    </>
  )
}

/** Shortened where there is no room for it; whole under the pointer, and when it has the focus. */
function Remark({ words }: { words: string }) {
  return (
    <button type="button" class="remark" data-tip={words}>
      <Icon icon={TriangleAlert} size={14} />
      <span role="status">{words}</span>
    </button>
  )
}
