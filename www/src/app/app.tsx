import { signal } from '@preact/signals'
import { LoaderCircle, TriangleAlert } from 'lucide'
import { Dialogs } from '../dialogs/dialog_switch'
import { t } from '../i18n'
import { describeError } from '../i18n/errors'
import { NotePlace } from '../panels/note_place'
import { PanelGrid } from '../panels/panel_grid'
import {
  catalog,
  focused,
  isOutdated,
  lesson,
  reloadPage,
  showView,
  startError,
  startPage,
  view,
} from '../state'
import { lazyParts } from '../state/lazy_parts'
import { PlayBar } from '../toolbar/play_bar'
import { Toolbar } from '../toolbar/toolbar'
import { Button } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { Toasts } from '../ui/toasts'
import { ColumnPlace } from './column_place'
import { DropVeil } from './drop_files'
import { Header } from './header'

/** The laboratory: fetched, with its words, when somebody wants to compare. */
const Lab = lazily(() => import('../lab').then((lab) => lab.fetchLab()).catch(leaveLab), Loading)

/** Offers to explain what was sent. */
const TargetStrip = lazily(() => lazyParts.lesson('target'))

/** Goes back to the race when the laboratory could not be fetched; it can be asked for again. */
function leaveLab(error: unknown): never {
  showView('race', 'replace')
  throw error
}

/** Header first, then the rest, as two tasks. */
const drawsAll = signal(false)
export const drawRest = () => {
  drawsAll.value = true
}

export function App() {
  return (
    <div class="app" data-view={view.value} data-focus={focused.value !== null}>
      <Header />
      {drawsAll.value && <Body />}
      <Dialogs />
      <Toasts />
      <DropVeil />
    </div>
  )
}

function Body() {
  if (startError.value) return <StartFailed />
  if (!catalog.value) return <Loading />
  return (
    <>
      {view.value === 'lab' && <Lab />}
      <Race hidden={view.value === 'lab'} />
    </>
  )
}

/** Hidden rather than gone: canvases whose drawing has been handed to workers do not come back. */
function Race({ hidden }: { hidden: boolean }) {
  return (
    <main class="page" hidden={hidden}>
      <Toolbar />
      <NotePlace />
      {lesson.value?.target && <TargetStrip />}
      <div class="workbench">
        <PanelGrid />
        <ColumnPlace />
      </div>
      <PlayBar />
      <p id="stage-help" class="visually-hidden">
        {t('stage.help')}
      </p>
    </main>
  )
}

function Loading() {
  return (
    <main class="empty" data-testid="loading">
      <span class="spinner">
        <Icon icon={LoaderCircle} size={32} />
      </span>
      <p role="status">{t('app.loading')}</p>
    </main>
  )
}

function StartFailed() {
  const { message, hint } = describeError(startError.value)
  const reload = isOutdated(startError.value)
  return (
    <main class="empty" data-testid="start-failed">
      <Icon icon={TriangleAlert} size={36} />
      <h2>{t('app.failed')}</h2>
      <p role="alert">{reload ? message : t('app.failedHint')}</p>
      <Button
        label={t(reload ? 'app.reload' : 'app.retry')}
        tone="primary"
        onClick={() => (reload ? reloadPage() : startPage())}
      />
      <p class="hint">{reload ? hint : message}</p>
    </main>
  )
}
