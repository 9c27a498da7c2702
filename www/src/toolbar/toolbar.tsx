import { PanelBottom, PanelRight } from 'lucide'
import { t } from '../i18n'
import { AddPlannerMenu } from '../panels/add_planner'
import { columnOpen, compact, panels, toggleColumn } from '../state'
import { IconButton } from '../ui/buttons'
import { EditTools } from './edit_tools'
import { SyncField } from './run_settings'
import { ViewControls } from './view_controls'

/** Drawing, looking and adding, in one row above the maps. */
export function Toolbar() {
  return (
    <div class="toolbar">
      <EditTools />
      <span class="spacer" />
      {panels.value.length > 0 && <ViewControls />}
      <span class="toolbar-group">
        {!compact.value && <SyncField />}
        <AddPlannerMenu />
        <ColumnButton />
      </span>
    </div>
  )
}

/** Opens and closes the column with charts, parameters and numbers. */
function ColumnButton() {
  return (
    <IconButton
      icon={compact.value ? PanelBottom : PanelRight}
      label={t('column.toggle')}
      keys="C"
      pressed={columnOpen.value}
      testId="column"
      onClick={toggleColumn}
    />
  )
}
