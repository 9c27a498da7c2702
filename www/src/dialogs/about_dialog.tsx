/** Explains what is on show to somebody who was sent it: what it is, whether it holds, how good it is, what to do with it. */
import '../styles/about.css'
import { useEffect, useState } from 'preact/hooks'
import { addAboutWords, t } from '../i18n/about'
import { notifyError, view } from '../state'
import { closeDialog } from '../state/dialogs'
import { lazyParts } from '../state/lazy_parts'
import { received } from '../state/received'
import { Dialog } from '../ui/dialog'
import { lazily } from '../ui/lazily'
import { AboutRace } from './about_race'

const AboutComparison = lazily(async () => (await lazyParts.lab()).AboutComparison)

export function AboutDialog() {
  const [ready, setReady] = useState(false)
  useEffect(() => {
    received.value = false
    addAboutWords().then(() => setReady(true), notifyError)
  }, [])
  if (!ready) return null
  return (
    <Dialog title={t('about.title')} onClose={closeDialog} testId="about-dialog" wide>
      <div class="about-result" data-testid="about">
        {view.value === 'lab' ? <AboutComparison /> : <AboutRace />}
      </div>
    </Dialog>
  )
}
