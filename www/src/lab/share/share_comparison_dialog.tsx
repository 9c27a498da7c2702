/** Shares the open comparison as a link, a file or a picture. */

import { SendDialog, useLink } from '../../dialogs/send_dialog'
import { t } from '../../i18n/lab'
import { encodeDocument, PREFIX } from '../../share/comparison_link'
import { download } from '../../state/export_files'
import { openComparison, progress, resultFile } from '../run/actions'
import { fileStem } from '../store/names'
import { shownComparison } from '../store/shown_comparison'
import { resultCard } from './result_card'

export function ShareComparisonDialog({ onClose }: { onClose: () => void }) {
  const link = useLink(PREFIX, async () => encodeDocument(await resultFile('link')))
  return (
    <SendDialog
      title={t('lab.share.title')}
      what={t('lab.share.what')}
      link={link}
      tooLong={(lengths) => t('lab.share.tooLong', lengths)}
      tooLarge={t('lab.share.tooLarge')}
      savePicture={saveCard}
      saveFile={saveFile}
      onClose={onClose}
      testId="lab-share"
    >
      <Contents />
    </SendDialog>
  )
}

/** Lists what the link holds, so that nothing is shared unseen. */
function Contents() {
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
    </ul>
  )
}

const stem = () => fileStem(openComparison.peek()?.title ?? '')

async function saveFile(): Promise<void> {
  download(`${stem()}.result.json`, await resultFile('json'), 'application/json')
}

async function saveCard(): Promise<void> {
  const png = await resultCard()
  download(`${stem()}.png`, new Uint8Array(await png.arrayBuffer()), 'image/png')
}
