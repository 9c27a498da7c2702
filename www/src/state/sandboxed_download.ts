/** Says that a download may not have come, and offers its text. Fetched when it is wanted. */
import { addEmbedWords, t } from '../i18n/embed'
import { putOnClipboard } from './clipboard'
import { notify } from './notices'

export async function tellOfDownload(content: string | Uint8Array | Blob): Promise<void> {
  await addEmbedWords()
  if (typeof content !== 'string') {
    notify('warning', t('embed.download'), { hint: t('embed.downloadHint') })
    return
  }
  const copy = async () => {
    const copied = await putOnClipboard(content)
    notify(copied ? 'success' : 'warning', t(copied ? 'common.copied' : 'common.copyFailed'))
  }
  notify('warning', t('embed.download'), {
    hint: t('embed.downloadText'),
    action: { label: t('embed.copyText'), run: () => void copy() },
  })
}
