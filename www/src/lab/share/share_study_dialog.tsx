/** The open study as a link, a file or a picture. */
import { Copy, FileDown, ImageDown } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { LINK_LIMIT } from '../../share/envelope'
import { LinkError } from '../../share/error'
import { download, notifyError } from '../../state'
import { Button } from '../../ui/buttons'
import { copyText } from '../../ui/copy'
import { Dialog } from '../../ui/dialog'
import { fileStem } from '../names'
import { progress, resultFile, study } from '../state'
import { resultCard } from './card'
import { encodeDocument, PREFIX } from './link'

/** In the place of a link that cannot be. */
const TOO_LARGE = 'too large'

export function ShareStudyDialog({ onClose }: { onClose: () => void }) {
  const link = useLink()
  const tooLong = link === TOO_LARGE || (link !== null && link.length > LINK_LIMIT)
  return (
    <Dialog
      title={t('lab.share.title')}
      onClose={onClose}
      testId="lab-share-dialog"
      actions={
        <>
          <Button
            icon={ImageDown}
            label={t('lab.share.picture')}
            testId="lab-share-picture"
            onClick={() => void saveCard().catch(notifyError)}
          />
          <Button
            icon={FileDown}
            label={t('lab.share.file')}
            tone={tooLong ? 'primary' : 'plain'}
            testId="lab-share-file"
            onClick={() => void saveFile().catch(notifyError)}
          />
          {!tooLong && (
            <Button
              icon={Copy}
              label={t('lab.share.copy')}
              tone="primary"
              testId="lab-share-copy"
              disabled={link === null}
              onClick={() => copyText(link ?? '')}
            />
          )}
        </>
      }
    >
      <p>{t('lab.share.what')}</p>
      <Contents />
      {tooLong ? <TooLong link={link ?? ''} /> : <Link link={link} />}
    </Dialog>
  )
}

/** What the link will bring along, so that nothing is shared unseen. */
function Contents() {
  const now = study.value
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

function Link({ link }: { link: string | null }) {
  return (
    <>
      <input
        class="input share-link"
        readOnly
        value={link ?? t('common.working')}
        aria-label={t('lab.share.link')}
        data-testid="lab-share-link"
        onFocus={(event) => event.currentTarget.select()}
      />
      <p class="hint">
        {t('lab.share.private', { length: numbers.value.whole.format(link?.length ?? 0) })}
      </p>
    </>
  )
}

function TooLong({ link }: { link: string }) {
  const { whole } = numbers.value
  return (
    <p class="banner" data-testid="lab-share-too-long">
      {link === TOO_LARGE
        ? t('lab.share.tooLarge')
        : t('lab.share.tooLong', {
            length: whole.format(link.length),
            limit: whole.format(LINK_LIMIT),
          })}
    </p>
  )
}

/** The whole address, or that it is too large; null while it is being made. Of one moment: runs may go on behind the dialog. */
function useLink(): string | null {
  const [link, setLink] = useState<string | null>(null)
  useEffect(() => {
    const page = location.href.replace(/#.*$/, '')
    resultFile('link')
      .then(encodeDocument)
      .then(
        (text) => setLink(`${page}${PREFIX}${text}`),
        (error) => {
          if (error instanceof LinkError) setLink(TOO_LARGE)
          else notifyError(error)
        },
      )
  }, [])
  return link
}

const stem = () => fileStem(study.peek()?.title ?? '')

async function saveFile(): Promise<void> {
  download(`${stem()}.result.json`, await resultFile('json'), 'application/json')
}

async function saveCard(): Promise<void> {
  const png = await resultCard()
  download(`${stem()}.png`, new Uint8Array(await png.arrayBuffer()), 'image/png')
}
