/** Offers to explain what a link has brought. It has the room that the header keeps free, so that nothing moves when it comes or goes. */
import '../styles/about.css'
import { Mail } from 'lucide'
import { addAboutWords, t } from '../i18n/about'
import { show } from '../state/dialogs'
import { received } from '../state/received'
import { Button, CloseButton } from '../ui/buttons'
import { Icon } from '../ui/icon'

function ReceivedStrip() {
  return (
    <aside class="received" aria-label={t('about.title')} data-testid="received">
      <Icon icon={Mail} size={16} />
      <span>{t('about.strip')}</span>
      <Button
        label={t('about.what')}
        tone="quiet"
        testId="received-what"
        onClick={() => show('about')}
      />
      <CloseButton
        label={t('about.hide')}
        testId="received-hide"
        onClick={() => {
          received.value = false
        }}
      />
    </aside>
  )
}

/** With its words. */
export const fetchStrip = () => addAboutWords().then(() => ReceivedStrip)
