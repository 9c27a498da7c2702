import { LoaderCircle, TriangleAlert } from 'lucide'
import { Header } from './header/header'
import { Welcome } from './help/welcome'
import { t } from './i18n'
import { describeError } from './i18n/errors'
import { DropVeil } from './maps/drop'
import { Dock } from './panels/dock'
import { PanelGrid } from './panels/panel_grid'
import { RaceStrip } from './panels/race_strip'
import { catalog, startError, startPage } from './state'
import { Toolbar } from './toolbar/toolbar'
import { Button } from './ui/buttons'
import { Dialogs } from './ui/dialog_switch'
import { Icon } from './ui/icon'
import { Toasts } from './ui/toasts'

export function App() {
  return (
    <div class="app">
      <Header />
      <Body />
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
    <main class="page">
      <Toolbar />
      <div class="content">
        <Welcome />
        <RaceStrip />
        <PanelGrid />
        <Dock />
      </div>
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
  const { message } = describeError(startError.value)
  return (
    <main class="empty" data-testid="start-failed">
      <Icon icon={TriangleAlert} size={36} />
      <h2>{t('app.failed')}</h2>
      <p role="alert">{t('app.failedHint')}</p>
      <Button label={t('app.retry')} tone="primary" onClick={() => startPage()} />
      <p class="hint">{message}</p>
    </main>
  )
}
