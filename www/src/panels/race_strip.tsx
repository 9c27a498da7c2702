import type { Objective, ScenarioSpec, SliceRules } from '@pkg/formicarium'
import { Bug, Equal, Maximize, Route, ZoomIn, ZoomOut } from 'lucide'
import { numbers, t } from '../i18n'
import { describeNotice } from '../i18n/errors'
import { layerChoices } from '../model/session'
import {
  layer,
  objectives,
  panels,
  plannerEntry,
  referenceRefusal,
  references,
  sameScale,
  scenario,
  scenarioNotices,
  setSameScale,
  showAnts,
  showPath,
  wholeEngine,
} from '../state'
import { show } from '../state/dialogs'
import { fitWholeMap, onTerrain, zoomView } from '../state/relief'
import { IconButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { lazily } from '../ui/lazily'
import { referenceValue } from '../words/gap_words'
import { objectiveWord } from '../words/objective_words'
import { AddPlannerMenu } from './add_planner'
import { showGoals } from './goals_shown'

const ReliefControls = lazily(
  async () => (await import('../relief/relief_controls')).ReliefControls,
)

const CompareButton = lazily(async () => (await import('../playback')).fetchCompareButton())

/** What is being raced for, in one line, and how to look at it. The target comes last, so that nothing moves when it becomes known. */
export function RaceStrip() {
  return (
    <section class="race-strip" aria-label={t('race.region')}>
      <p class="race-words">
        {panels.value.length > 0 && (
          <span class="race-what">{t('race.what', { count: panels.value.length })}</span>
        )}
        <GoalCount />
        <TerrainModel />
        <Target />
      </p>
      <ScenarioRemarks />
      <span class="spacer" />
      {panels.value.length > 0 && <ViewControls />}
      <AddPlannerMenu />
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
        ? t('race.target', { what, value: numbers.value.length.format(value) })
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
        <span key={notice.kind} class="remark" role="status">
          {describeNotice(notice)}
        </span>
      ))}
    </>
  )
}

const LAYERS = layerChoices()

function ViewControls() {
  const offered = new Set(
    panels.value.flatMap(({ setup }) => plannerEntry(setup.planner)?.layers ?? []),
  )
  return (
    <div class="view-controls" role="toolbar" aria-label={t('view.group')}>
      <Select
        label={t('view.layer')}
        value={layer.value}
        testId="layer"
        note={layer.value === 'none' ? undefined : t(`view.layerNotes.${layer.value}`)}
        options={LAYERS.filter((id) => id === layer.value || id === 'none' || offered.has(id)).map(
          (id) => ({
            value: id,
            label: t(`view.layers.${id}`),
            note: id === 'none' ? undefined : t(`view.layerNotes.${id}`),
          }),
        )}
        onChange={(id) => {
          layer.value = id
        }}
      />
      <IconButton
        icon={Equal}
        label={t('view.sameScale')}
        pressed={sameScale.value}
        testId="same-scale"
        disabled={panels.value.length < 2}
        onClick={() => setSameScale(!sameScale.value)}
      />
      <IconButton
        icon={Bug}
        label={t('view.ants')}
        pressed={showAnts.value}
        testId="show-ants"
        onClick={() => {
          showAnts.value = !showAnts.value
        }}
      />
      <IconButton
        icon={Route}
        label={t('view.path')}
        pressed={showPath.value}
        testId="show-path"
        onClick={() => {
          showPath.value = !showPath.value
        }}
      />
      {panels.value.length > 1 && wholeEngine.value === 'here' && <CompareButton />}
      {onTerrain.value && <ReliefControls />}
      <span class="divider" />
      <IconButton icon={ZoomOut} label={t('view.out')} onClick={() => zoomView(1 / 1.4)} />
      <IconButton
        icon={Maximize}
        label={t('view.fit')}
        keys="0"
        testId="fit"
        onClick={fitWholeMap}
      />
      <IconButton icon={ZoomIn} label={t('view.in')} onClick={() => zoomView(1.4)} />
    </div>
  )
}
