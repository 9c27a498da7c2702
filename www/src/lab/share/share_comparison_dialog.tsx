/** Shares the open comparison as a link, a file or a picture. */
import { CircleQuestionMark, Users } from 'lucide'
import { useState } from 'preact/hooks'
import type { PageContents } from '../../dialogs/save_page'
import { SendDialog, useLink } from '../../dialogs/send_dialog'
import { t as tOfDialogs } from '../../i18n/dialogs'
import { t } from '../../i18n/lab'
import { PREFIX } from '../../share/comparison_link'
import { show } from '../../state/dialogs'
import { download } from '../../state/export_files'
import { Button } from '../../ui/buttons'
import { openComparison, progress, resultFile } from '../run/actions'
import { runsOfQuestion } from '../run/shares'
import { fileStem } from '../store/names'
import { shownComparison } from '../store/shown_comparison'
import { noteSaved } from '../store/unstored'
import { ClassDialog, LEAST_SHARES } from './class_dialog'
import { linkOfNow } from './link_of_now'
import { resultCard } from './result_card'

export function ShareComparisonDialog({ onClose }: { onClose: () => void }) {
  const [forClass, setForClass] = useState(false)
  if (forClass) return <ClassDialog onBack={() => setForClass(false)} onClose={onClose} />
  return <SendComparison onClass={() => setForClass(true)} onClose={onClose} />
}

interface SendProps {
  /** The runs are to be shared out instead. */
  onClass: () => void
  onClose: () => void
}

function SendComparison({ onClass, onClose }: SendProps) {
  const [carriesNumbers, setCarriesNumbers] = useState(false)
  const link = useLink(PREFIX, async () => {
    const made = await linkOfNow()
    setCarriesNumbers(made.carriesNumbers)
    return made.text
  })
  return (
    <SendDialog
      title={t('lab.share.title')}
      name={shownComparison.value?.title ?? ''}
      what={t('lab.share.what')}
      link={link}
      tooLong={(lengths) => t('lab.share.tooLong', lengths)}
      tooLarge={t('lab.share.tooLarge')}
      savePicture={saveCard}
      saveFile={saveFile}
      pageOf={pageOf}
      onClose={onClose}
      testId="lab-share"
    >
      <Contents carriesNumbers={carriesNumbers} />
      <Button
        icon={CircleQuestionMark}
        label={tOfDialogs('share.about')}
        tone="quiet"
        testId="lab-share-about"
        onClick={() => {
          onClose()
          show('about')
        }}
      />
      <div class="class-offer">
        <Button
          icon={Users}
          label={t('lab.class.open')}
          testId="lab-share-class"
          disabled={runsOfQuestion().all < LEAST_SHARES}
          onClick={onClass}
        />
        <p class="hint">{t('lab.class.openHint')}</p>
      </div>
    </SendDialog>
  )
}

/** Lists what the link holds, so that nothing is shared unseen. */
function Contents({ carriesNumbers }: { carriesNumbers: boolean }) {
  const now = shownComparison.value
  if (!now) return null
  const { instances, entries, seeds } = now.question
  const { done } = progress.value
  return (
    <ul class="share-contents">
      <li>
        {t('lab.share.carriesQuestion', {
          title: now.title,
          maps: t('lab.share.carriesMaps', { count: instances.length }),
          entries: t('lab.share.carriesEntries', { count: entries.length }),
          seeds: t('lab.share.carriesSeeds', { count: seeds.count }),
        })}
      </li>
      <li>
        {done > 0 ? t('lab.share.carriesRuns', { count: done }) : t('lab.share.carriesNoRuns')}
      </li>
      {carriesNumbers && <li>{t('lab.recorded.carries')}</li>}
    </ul>
  )
}

const stem = () => fileStem(openComparison.peek()?.title ?? '')

async function pageOf(): Promise<PageContents> {
  const now = openComparison.peek()
  return {
    text: await resultFile('json'),
    title: shownComparison.peek()?.title ?? '',
    stem: stem(),
    saved: () => now && noteSaved(now.id),
  }
}

async function saveFile(): Promise<void> {
  download(`${stem()}.result.json`, await resultFile('json'), 'application/json')
}

async function saveCard(): Promise<void> {
  const png = await resultCard()
  download(`${stem()}.png`, new Uint8Array(await png.arrayBuffer()), 'image/png')
}
