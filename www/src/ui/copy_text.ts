/** Copies text to the clipboard. */
import { t } from '../i18n'
import { announce, notify } from '../state'

export async function copyText(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text)
    notify('success', t('common.copied'))
    announce(t('common.copied'))
  } catch {
    notify('warning', t('common.copyFailed'), { hint: t('common.copyFailedHint') })
  }
}
