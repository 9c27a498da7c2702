/** Handing the open study on, and whether what was handed on comes out again. */
import '../../styles/lab_share.css'
import { Share2 } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { Button } from '../../ui/buttons'
import { embedInPictures } from '../figures/download'
import { withStudy } from './picture'
import { ShareStudyDialog } from './share_comparison_dialog'

export { VerificationPanel } from './verification_panel'

embedInPictures(withStudy)

export function ShareStudy() {
  const [open, setOpen] = useState(false)
  return (
    <>
      <Button
        icon={Share2}
        label={t('lab.share.open')}
        testId="lab-share"
        onClick={() => setOpen(true)}
      />
      {open && <ShareStudyDialog onClose={() => setOpen(false)} />}
    </>
  )
}
