import { useSignal } from '@preact/signals'
import { LoaderCircle, Unlink } from 'lucide'
import { useEffect } from 'preact/hooks'
import { Dialogs } from '../../dialogs/dialog_switch'
import { t } from '../../i18n/embed'
import type { Control } from '../../model/embedding'
import { PanelGrid } from '../../panels/panel_grid'
import { scenario, startError, view } from '../../state'
import { EditTools } from '../../toolbar/edit_tools'
import { ViewControls } from '../../toolbar/view_controls'
import { Icon } from '../../ui/icon'
import { lazily } from '../../ui/lazily'
import { Toasts } from '../../ui/toasts'
import { DropVeil } from '../drop_files'
import { Bar } from './bar'
import { panelCardWith } from './embedded_panel'

const ChartsPlace = lazily(async () => (await import('./charts_place')).ChartsPlace)

const Lab = lazily(() => import('../../lab').then((lab) => lab.fetchLab()), Loading)

interface EmbeddedProps {
  controls: ReadonlySet<Control>
  /** Resolves once there is something on show, or it is known that there will be nothing. */
  started: Promise<unknown>
}

export function Embedded({ controls, started }: EmbeddedProps) {
  const settled = useSignal(false)
  useEffect(() => {
    void started.then(() => {
      settled.value = true
    })
  }, [started])
  const inLab = view.value === 'lab'
  return (
    <div class="app embedded" data-view={view.value}>
      {inLab && <Lab />}
      <main class="page" hidden={inLab}>
        {scenario.value ? (
          <Race controls={controls} />
        ) : settled.value ? (
          <NothingRead />
        ) : (
          <Loading />
        )}
      </main>
      <Bar controls={inLab || !scenario.value ? NONE : controls} />
      {(controls.has('open') || controls.has('charts')) && <Dialogs />}
      <Toasts />
      <DropVeil />
    </div>
  )
}

const NONE: ReadonlySet<Control> = new Set()

const WithNumbers = panelCardWith({ numbers: true })
const WithoutNumbers = panelCardWith({ numbers: false })

function Race({ controls }: Pick<EmbeddedProps, 'controls'>) {
  const hasTools = controls.has('edit') || controls.has('layers')
  return (
    <>
      {hasTools && (
        <div class="toolbar">
          {controls.has('edit') && <EditTools />}
          <span class="spacer" />
          {controls.has('layers') && <ViewControls />}
        </div>
      )}
      <div class="workbench">
        <PanelGrid Card={controls.has('numbers') ? WithNumbers : WithoutNumbers} />
        {controls.has('charts') && <ChartsPlace />}
      </div>
      <p id="stage-help" class="visually-hidden">
        {t('stage.help')}
      </p>
    </>
  )
}

function Loading() {
  return (
    <div class="empty" data-testid="loading">
      <span class="spinner">
        <Icon icon={LoaderCircle} size={28} />
      </span>
      <p role="status">{t('app.loading')}</p>
    </div>
  )
}

/** The engine did not start, or the address holds a link that cannot be read. */
function NothingRead() {
  const failed = startError.value !== null
  return (
    <div class="empty" role="alert" data-testid="embed-nothing">
      <Icon icon={Unlink} size={28} />
      <h2>{t(failed ? 'app.failed' : 'embed.unread')}</h2>
      <p>{t(failed ? 'app.failedHint' : 'embed.unreadHint')}</p>
    </div>
  )
}
