/** A panel's button that saves its path for other programs. */
import { useComputed } from '@preact/signals'
import { Download } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../i18n'
import { type Panel, panelById, shownOf } from '../state'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { Menu } from '../ui/menu'
import { panelTitle } from '../words/planner_words'

/** Formats and their words come with the first look. */
const PathItems = lazily(async () => (await import('./path_items')).fetchPathItems())

interface PathMenuProps {
  panel: Panel
  place: number
}

export function PathMenu({ panel: { id }, place }: PathMenuProps) {
  const [looked, setLooked] = useState(false)
  // The run's numbers change many times a second; the menu only cares whether there is a path.
  const found = useComputed(() => {
    const panel = panelById(id)
    return panel !== undefined && (shownOf(panel).bestPath?.length ?? 0) > 0
  })
  return (
    <span class="path-menu">
      <Menu
        bare
        align="end"
        label={t('panels.savePath', { planner: panelTitle(id) })}
        testId={`save-path-${place}`}
        face={<Icon icon={Download} size={16} />}
        onOpen={() => setLooked(true)}
      >
        {looked && <PathItems panelId={id} found={found.value} />}
      </Menu>
    </span>
  )
}
