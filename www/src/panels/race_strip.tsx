import type { Layer } from '@pkg/formicarium'
import { Bug, Maximize, Route, ZoomIn, ZoomOut } from 'lucide'
import { numbers, t } from '../i18n'
import { describeNotice } from '../i18n/errors'
import { fitView, zoomBy } from '../stage/view'
import {
  layer,
  optimum,
  panels,
  plannerEntry,
  scenario,
  scenarioNotices,
  showAnts,
  showPath,
} from '../state'
import { IconButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { AddPlannerMenu } from './add_planner'

/** What is being raced for, in one line, and how to look at it. */
export function RaceStrip() {
  return (
    <section class="race-strip" aria-label={t('race.region')}>
      <p class="race-words">
        {panels.value.length > 0 && <span>{t('race.what', { count: panels.value.length })}</span>}
        <Target />
      </p>
      <ScenarioRemarks />
      <span class="spacer" />
      {panels.value.length > 0 && <ViewControls />}
      <AddPlannerMenu />
    </section>
  )
}

function Target() {
  const best = optimum.value
  if (!scenario.value) return null
  const words =
    best === null
      ? t('race.proving')
      : Number.isFinite(best)
        ? t('race.target', { length: numbers.value.length.format(best) })
        : t('race.unreachable')
  return (
    <span
      class={best === Number.POSITIVE_INFINITY ? 'target remark' : 'target'}
      data-testid="optimum"
      data-value={best ?? ''}
    >
      {words}
    </span>
  )
}

/** The engine's remarks; that there is no path, the target says already. */
function ScenarioRemarks() {
  const remarks = scenarioNotices.value.filter(({ kind }) => kind !== 'unreachable')
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

const LAYERS: (Layer | 'none')[] = ['trail', 'visits', 'heuristic', 'cost', 'none']

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
        options={LAYERS.filter((id) => id === layer.value || id === 'none' || offered.has(id)).map(
          (id) => ({
            value: id,
            label: t(`view.layers.${id}`),
          }),
        )}
        onChange={(id) => {
          layer.value = id
        }}
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
      <span class="divider" />
      <IconButton icon={ZoomOut} label={t('view.out')} onClick={() => zoomBy(1 / 1.4)} />
      <IconButton icon={Maximize} label={t('view.fit')} keys="0" testId="fit" onClick={fitView} />
      <IconButton icon={ZoomIn} label={t('view.in')} onClick={() => zoomBy(1.4)} />
    </div>
  )
}
