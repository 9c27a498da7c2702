import { useEffect, useState } from 'preact/hooks'
import { language, t } from '../i18n'
import { closeDialog } from '../state/dialogs'
import { Dialog } from '../ui/dialog'
import { FormError } from '../ui/form_error'
import { cardText, openCard } from '../words/paper_cards'
import type { Card } from './markdown'

type Markdown = typeof import('./markdown')

/** A paper's card, as it stands in docs/papers. */
export function CardDialog() {
  const [read, setRead] = useState<{ card: Card; Blocks: Markdown['Blocks'] } | null>(null)
  const [error, setError] = useState<unknown>(null)
  useEffect(() => {
    Promise.all([cardText(openCard.value), import('./markdown')]).then(
      ([text, { readCard, Blocks }]) => setRead({ card: readCard(text), Blocks }),
      setError,
    )
  }, [])
  return (
    <Dialog
      title={read?.card.title ?? t('papers.title')}
      onClose={closeDialog}
      testId="card-dialog"
      wide
    >
      {error !== null && <FormError error={error} />}
      {!read && error === null && <p role="status">{t('common.working')}</p>}
      {read && language.value !== 'en' && <p class="hint">{t('papers.inEnglish')}</p>}
      {read && (
        <article class="card" lang="en">
          <read.Blocks tokens={read.card.body} />
        </article>
      )}
    </Dialog>
  )
}
