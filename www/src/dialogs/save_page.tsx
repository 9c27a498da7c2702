/** "Save as a page" in the share dialogs: one file with the whole program and what is shared inside. */
import { AppWindow } from 'lucide'
import { useState } from 'preact/hooks'
import { language } from '../i18n'
import { t } from '../i18n/dialogs'
import { oneFile } from '../model/one_file'
import { ABOUT_MB, pageAddress, pageTemplate, pageWith } from '../share/page_file'
import { notifyError } from '../state'
import { download } from '../state/export_files'
import { Button } from '../ui/buttons'

/** What a page is to carry. */
export interface PageContents {
  /** A session's or comparison's file. */
  text: string
  title: string
  /** The name of the file, without its ending. */
  stem: string
  /** Called once it is saved. */
  saved(): void
}

interface SavedPage {
  isFetching: boolean
  /** Why the page could not be fetched. */
  refusal: string | null
  save(): Promise<void>
}

export function useSavedPage(contents: () => Promise<PageContents>): SavedPage {
  const [isFetching, setFetching] = useState(false)
  const [refusal, setRefusal] = useState<string | null>(null)
  const save = async () => {
    setFetching(true)
    setRefusal(null)
    const template = await pageTemplate().catch((error: unknown) => {
      setRefusal(error instanceof Error ? error.message : String(error))
      return null
    })
    setFetching(false)
    if (template === null) return
    const { text, title, stem, saved } = await contents()
    download(`${stem}.html`, pageWith(template, title, text), 'text/html')
    saved()
  }
  return { isFetching, refusal, save }
}

export function SavePage({ page, testId }: { page: SavedPage; testId: string }) {
  return (
    <Button
      icon={AppWindow}
      label={t(page.isFetching ? 'onePage.saving' : 'onePage.save')}
      testId={testId}
      busy={page.isFetching}
      onClick={() => void page.save().catch(notifyError)}
    />
  )
}

/** What a page is, and why there is none. */
export function PageHints({ page, testId }: { page: SavedPage; testId: string }) {
  const size = new Intl.NumberFormat(language.value).format(ABOUT_MB)
  return (
    <>
      {oneFile() && pageAddress() === '' && <p class="hint">{t('onePage.bare')}</p>}
      <p class="hint" data-testid={`${testId}-page-hint`}>
        {oneFile()
          ? t('onePage.keepsNothing')
          : `${t('onePage.hint', { size })} ${t('onePage.from')}`}
      </p>
      {page.refusal !== null && (
        <p class="banner" role="alert" data-testid={`${testId}-page-refused`}>
          {t('onePage.unreachable', { why: page.refusal })} {t('onePage.unreachableHint')}
        </p>
      )}
    </>
  )
}
