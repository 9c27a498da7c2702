/** The button that shares the open comparison, and the panel that verifies a shared one. */
import '../../styles/lab_class.css'
import '../../styles/lab_share.css'
import { Share2 } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { Button } from '../../ui/buttons'
import { embedInPictures } from '../figures/download'
import { embedComparison } from './embed_comparison'
import { ShareComparisonDialog } from './share_comparison_dialog'

export { CollectedCard } from './collected_card'
export { ShareCard } from './share_card'
export { VerificationPanel } from './verification_panel'

embedInPictures(embedComparison)

export function ShareComparison() {
  const [open, setOpen] = useState(false)
  return (
    <>
      <Button
        icon={Share2}
        label={t('lab.share.open')}
        testId="lab-share"
        onClick={() => setOpen(true)}
      />
      {open && <ShareComparisonDialog onClose={() => setOpen(false)} />}
    </>
  )
}
