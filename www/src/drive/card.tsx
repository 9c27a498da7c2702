/** Beside the maps while a robot drives: what it does, what that comes to, what moves, and how it drives. */
import '../styles/column_parameters.css'
import '../styles/drive.css'
import { useEffect } from 'preact/hooks'
import { t } from '../i18n/drive'
import { Card } from '../lesson/card'
import { panels } from '../state'
import { mapIsFixed } from '../state/embedding'
import { Select } from '../ui/fields'
import { panelTitle } from '../words/planner_words'
import { choosePanel, closeDrive, drivingPanel, failure, keepDriving } from './drive'
import { edited } from './moving'
import { MovingList } from './moving_list'
import { MapKey, Numbers } from './numbers'
import { Settings } from './settings'
import { isUndrivable, standingWords } from './standing_words'
import { Transport } from './transport'

export function DriveCard() {
  useEffect(() => {
    const end = keepDriving()
    return () => {
      edited.value = null
      end()
    }
  }, [])
  const panel = drivingPanel.value
  return (
    <Card
      title={t('drive.title')}
      line={standingWords()}
      panelId={panel?.id ?? 0}
      testId="drive-card"
      onClose={closeDrive}
      onKey={leaveEditing}
    >
      {panel ? <Body panelId={panel.id} /> : <p class="hint">{standingWords()}</p>}
    </Card>
  )
}

function Body({ panelId }: { panelId: number }) {
  return (
    <>
      <Transport />
      {failure.value ? (
        <p role="alert" class="field-error">
          {standingWords()}
        </p>
      ) : (
        <p role="status" class="drive-standing" data-testid="drive-standing">
          {standingWords()}
        </p>
      )}
      {panels.value.length > 1 && (
        <Select
          label={t('drive.planner')}
          value={String(panelId)}
          testId="drive-planner"
          options={panels.value.map(({ id }) => ({ value: String(id), label: panelTitle(id) }))}
          onChange={(id) => choosePanel(Number(id))}
        />
      )}
      {!isUndrivable() && <Drivable />}
    </>
  )
}

function Drivable() {
  return (
    <>
      <Numbers />
      {!mapIsFixed.value && <MovingList />}
      <Settings />
      <MapKey />
    </>
  )
}

/** Esc first leaves what is being drawn. True when the key was used. */
function leaveEditing({ key }: KeyboardEvent): boolean {
  if (key !== 'Escape' || edited.peek() === null) return false
  edited.value = null
  return true
}
