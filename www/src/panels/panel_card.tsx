import type { EngineError } from '@pkg/formicarium'
import { useComputed } from '@preact/signals'
import { Expand, Fullscreen, LoaderCircle, Shrink, SlidersHorizontal } from 'lucide'
import { t } from '../i18n'
import { describeError } from '../i18n/errors'
import { Stage } from '../stage/stage'
import {
  catalog,
  columnOpen,
  focused,
  focusOn,
  isOutdated,
  leaveFocus,
  type Panel,
  panelById,
  plannerEntry,
  reloadPage,
  removePanel,
  reset,
  restart,
  selectedPanel,
  setPlanner,
  slotColour,
  toggleFullScreen,
  wholeEngine,
} from '../state'
import { Button, CloseButton, IconButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { Icon } from '../ui/icon'
import { FAMILIES, panelTitle, plannerName, whyNot } from '../words/planner_words'
import { PanelLabel } from './panel_label'
import { PathMenu } from './path_menu'
import { cardId, showParameters } from './places'
import { Readout } from './readout'
import { StatusChip } from './status_chip'

export interface PanelCardProps {
  panel: Panel
  /** 1 for the first on the page. */
  place: number
}

export function PanelCard({ panel, place }: PanelCardProps) {
  const { id, setup, slot } = panel
  const alone = focused.value
  return (
    <article
      class="panel"
      id={cardId(id)}
      style={{ '--panel-colour': slotColour(slot) }}
      aria-label={t('panels.label', { place, planner: panelTitle(id) })}
      data-testid={`panel-${place}`}
      data-selected={selectedPanel.value === id}
      hidden={alone !== null && alone !== id}
    >
      <header class="panel-head">
        <span class="panel-dot" aria-hidden="true" />
        <PanelLabel panelId={id} place={place} />
        <Select
          label={t('panels.planner')}
          hideLabel
          class="planner-select"
          value={setup.planner}
          testId={`planner-${place}`}
          options={plannerOptions(setup.planner)}
          onChange={(planner) => setPlanner(id, planner)}
        />
        <StatusChip panel={panel} place={place} />
        <Readout panel={panel} place={place} />
        <PanelButtons panel={panel} place={place} />
      </header>
      <PanelStage panel={panel} />
    </article>
  )
}

function PanelButtons({ panel, place }: PanelCardProps) {
  const { id } = panel
  const title = panelTitle(id)
  if (focused.value === id) return <FocusButtons panel={panel} place={place} />
  return (
    <span class="panel-buttons">
      <PathMenu panel={panel} place={place} />
      <IconButton
        icon={SlidersHorizontal}
        label={t('panels.parametersOf', { planner: title })}
        tone="quiet"
        size={16}
        pressed={selectedPanel.value === id && columnOpen.value}
        testId={`parameters-${place}`}
        onClick={() => showParameters(id)}
      />
      <IconButton
        icon={Expand}
        label={t('focus.on', { planner: title })}
        keys="F"
        tone="quiet"
        size={16}
        testId={`focus-${place}`}
        onClick={() => focusOn(id)}
      />
      <CloseButton
        label={t('panels.remove', { planner: title })}
        testId={`remove-${place}`}
        onClick={() => removePanel(id)}
      />
    </span>
  )
}

/** With the page to itself a panel can take the whole screen, or give the page back. */
function FocusButtons({ panel, place }: PanelCardProps) {
  return (
    <span class="panel-buttons">
      <PathMenu panel={panel} place={place} />
      <IconButton
        icon={Fullscreen}
        label={t('focus.fullScreen')}
        tone="quiet"
        testId="full-screen"
        onClick={toggleFullScreen}
      />
      <IconButton
        icon={Shrink}
        label={t('focus.leave')}
        keys="Esc"
        tone="quiet"
        testId="leave-focus"
        onClick={leaveFocus}
      />
    </span>
  )
}

/** The catalog's planners, and the panel's own while the part of the catalog that has it is on its way. */
function plannerOptions(own: string) {
  const known = catalog.value?.planners ?? []
  const options = FAMILIES.flatMap((family) =>
    known
      .filter((entry) => entry.family === family)
      .map((entry) => ({
        value: entry.id,
        label: plannerName(entry),
        group: t(`family.${family}`),
        disabled: entry.id !== own && whyNot(entry) !== null,
        note: whyNot(entry) ?? undefined,
      })),
  )
  return plannerEntry(own) ? options : [{ value: own, label: own }, ...options]
}

export function PanelStage({ panel }: { panel: Panel }) {
  const { id } = panel
  // The numbers of the run change many times a second; the stage only cares for a refusal.
  const refused = useComputed(() => (panelById(id)?.live.value.error ?? null) !== null)
  return (
    <div class="panel-stage" data-refused={refused}>
      <Stage panelId={id} />
      <PanelTrouble panel={panel} />
    </div>
  )
}

/** A refusal, or a worker that failed: said over the map, with the way out. */
function PanelTrouble({ panel }: { panel: Panel }) {
  const { error, crashed } = panel.live.value
  if (!plannerEntry(panel.setup.planner)) return <PlannerOnItsWay />
  if (crashed !== null) return <WorkerTrouble error={crashed} />
  if (!error) return null
  const { message, hint } = describeError(error)
  return (
    <div class="panel-trouble" role="alert">
      <p>{message}</p>
      <p class="hint">{hint}</p>
      {UNSUITED.includes(error.kind) && <UseAnother panel={panel} />}
      {isOfParameter(panel, error) && (
        <Button label={t('panels.toParameter')} onClick={() => showParameters(panel.id)} />
      )}
    </div>
  )
}

/** Then its field says the same, wherever that is: in a folded list, in a column that is closed or shows another panel. */
function isOfParameter({ setup }: Panel, { field }: EngineError): boolean {
  return plannerEntry(setup.planner)?.params.some(({ key }) => key === field) ?? false
}

/** A planner that has no worker any more, or has none yet. */
function WorkerTrouble({ error }: { error: EngineError }) {
  if (error.kind === 'part-unreachable') return <NotFetched />
  const { message, hint } = describeError(error)
  return (
    <div class="panel-trouble" role="alert">
      <p>{isOutdated(error) ? message : t('panels.crashed')}</p>
      <p class="hint">{isOutdated(error) ? hint : message}</p>
      {isOutdated(error) ? (
        <Button label={t('app.reload')} onClick={reloadPage} />
      ) : (
        <Button label={t('panels.restart')} onClick={reset} />
      )}
    </div>
  )
}

/** Refusals that another planner would not have. */
const UNSUITED = ['too-many-goals', 'ground']

/** The first planner that suits the map, of the same family if there is one, a press away. */
function UseAnother({ panel }: { panel: Panel }) {
  const family = plannerEntry(panel.setup.planner)?.family
  const suited = catalog.value?.planners.filter((entry) => whyNot(entry) === null) ?? []
  const other = suited.find((entry) => entry.family === family) ?? suited[0]
  if (!other) return null
  return (
    <Button
      label={t('panels.useInstead', { planner: plannerName(other) })}
      onClick={() => setPlanner(panel.id, other.id)}
    />
  )
}

/** The page opens without most planners; one that a link names is fetched first. */
function PlannerOnItsWay() {
  if (wholeEngine.value !== 'failed') {
    return (
      <div class="panel-waiting" role="status" data-testid="panel-waiting">
        <span class="spinner">
          <Icon icon={LoaderCircle} size={28} />
        </span>
        <p>{t('panels.fetching')}</p>
      </div>
    )
  }
  return <NotFetched />
}

function NotFetched() {
  return (
    <div class="panel-trouble" role="alert" data-testid="panel-not-fetched">
      <p>{t('panels.notFetched')}</p>
      <p class="hint">{t('panels.notFetchedHint')}</p>
      <Button label={t('app.retry')} onClick={restart} />
    </div>
  )
}
