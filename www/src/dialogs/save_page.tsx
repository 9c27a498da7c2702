/** "Save as a page" in the share dialogs: one file with the whole program and what is shared inside. */
import '../styles/save_page.css'
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

interface PageOfferProps {
  contents: () => Promise<PageContents>
  /** Prefix of all test ids. */
  testId: string
}

/** The button, what a page is, and why there is none. */
export function PageOffer({ contents, testId }: PageOfferProps) {
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
    if (template !== null) saveIn(template, await contents())
  }
  return (
    <div class="page-offer">
      <Button
        icon={AppWindow}
        label={t(isFetching ? 'onePage.saving' : 'onePage.save')}
        testId={`${testId}-page`}
        busy={isFetching}
        onClick={() => void save().catch(notifyError)}
      />
      {refusal === null ? (
        <p class="hint" data-testid={`${testId}-page-hint`}>
          {hint()}
        </p>
      ) : (
        <p class="field-error" role="alert" data-testid={`${testId}-page-refused`}>
          {t('onePage.unreachable', { why: refusal })}
        </p>
      )}
    </div>
  )
}

function saveIn(template: string, { text, title, stem, saved }: PageContents): void {
  download(`${stem}.html`, pageWith(template, title, text), 'text/html')
  saved()
}

function hint(): string {
  if (oneFile()) return t('onePage.keepsNothing')
  const size = new Intl.NumberFormat(language.value).format(ABOUT_MB)
  return t('onePage.hint', { size })
}

/** Of a page that came from no host: that its links have no address. */
export const BareLinkHint = () =>
  pageAddress() === '' ? <p class="hint">{t('onePage.bare')}</p> : null
