import { names } from '../state/lazy_parts'
import { panelTitle } from '../words/planner_words'

interface PanelLabelProps {
  panelId: number
  /** 1 for the first on the page. */
  place: number
}

/** What a panel is called; it can be changed as soon as the part of the page that does it is here. */
export function PanelLabel(props: PanelLabelProps) {
  const part = names.value
  return (
    <span class="panel-label">
      {part ? <part.PanelName {...props} /> : panelTitle(props.panelId)}
    </span>
  )
}
