/** Copies text to the clipboard. */
import { t } from '../i18n/column'
import { announce, notify } from '../state'
import { putOnClipboard } from '../state/clipboard'

export async function copyText(text: string): Promise<void> {
  if (await putOnClipboard(text)) {
    notify('success', t('common.copied'))
    announce(t('common.copied'))
  } else notify('warning', t('common.copyFailed'), { hint: t('common.copyFailedHint') })
}
