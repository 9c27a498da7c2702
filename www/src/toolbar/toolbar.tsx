import { EditTools } from './edit_tools'
import { RunSettings } from './run_settings'
import { Transport } from './transport'

export function Toolbar() {
  return (
    <div class="toolbar">
      <EditTools />
      <Transport />
      <RunSettings />
    </div>
  )
}
