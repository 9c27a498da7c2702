import type { ComponentType } from 'preact'
import { t } from '../../i18n'
import { type PanelCardProps, PanelStage } from '../../panels/panel_card'
import { cardId } from '../../panels/places'
import { Readout } from '../../panels/readout'
import { StatusChip } from '../../panels/status_chip'
import { slotColour } from '../../state'
import { panelTitle } from '../../words/planner_words'

/** A panel's map under its name, with the numbers of its run or without: nothing in its head can be pressed. */
export function panelCardWith({ numbers }: { numbers: boolean }): ComponentType<PanelCardProps> {
  return ({ panel, place }) => (
    <article
      class="panel"
      id={cardId(panel.id)}
      style={{ '--panel-colour': slotColour(panel.slot) }}
      aria-label={t('panels.label', { place, planner: panelTitle(panel.id) })}
      data-testid={`panel-${place}`}
    >
      <header class="panel-head">
        <span class="panel-dot" aria-hidden="true" />
        <span class="panel-label">{panelTitle(panel.id)}</span>
        <StatusChip panel={panel} place={place} />
        {numbers && <Readout panel={panel} place={place} />}
      </header>
      <PanelStage panel={panel} />
    </article>
  )
}
