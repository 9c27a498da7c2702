/** The entries of a legend that every chart has: one line a panel. */
import { panels, slotColour } from '../state'
import { panelTitle } from '../words/planner_words'

export function PanelKeys() {
  return (
    <>
      {panels.value.map(({ id, slot }) => (
        <li key={id} style={{ '--panel-colour': slotColour(slot) }}>
          <span class="line-sample best" aria-hidden="true" />
          {panelTitle(id)}
        </li>
      ))}
    </>
  )
}
