import { signal } from '@preact/signals'
import { BrickWall, Share2, SlidersHorizontal, X } from 'lucide'
import { t } from '../i18n/column'
import { showParameters } from '../panels/places'
import { guide, recall, remember, selectedPanel, tool } from '../state'
import { show } from '../state/dialogs'
import { Button, IconButton } from '../ui/buttons'

const SEEN_KEY = 'formicarium.welcomed'
const visible = signal(recall(SEEN_KEY) === null)

/** What this page is and what to do next; a lesson says it by itself. Once closed, it does not come back. */
export function Welcome() {
  if (!visible.value || guide.value !== null) return null
  return (
    <aside class="welcome" aria-label={t('welcome.region')} data-testid="welcome">
      <p>
        <strong>{t('welcome.title')}</strong> {t('welcome.text')}
      </p>
      <div class="button-row">
        <Button icon={BrickWall} label={t('welcome.draw')} tone="quiet" onClick={drawWall} />
        <Button
          icon={SlidersHorizontal}
          label={t('welcome.tune')}
          tone="quiet"
          onClick={tuneFirst}
        />
        <Button
          icon={Share2}
          label={t('welcome.share')}
          tone="quiet"
          onClick={() => show('share')}
        />
      </div>
      <IconButton
        icon={X}
        label={t('welcome.close')}
        tone="quiet"
        testId="welcome-close"
        onClick={close}
      />
    </aside>
  )
}

function drawWall(): void {
  tool.value = 'wall'
  document.querySelector<HTMLElement>('.panel-stage canvas')?.focus()
}

function tuneFirst(): void {
  if (selectedPanel.value !== null) showParameters(selectedPanel.value)
  document.querySelector<HTMLElement>('.parameter-list input, .parameter-list select')?.focus()
}

function close(): void {
  visible.value = false
  remember(SEEN_KEY, '1')
}
