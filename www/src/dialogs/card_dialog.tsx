import { useEffect, useState } from 'preact/hooks'
import '../styles/card.css'
import { language } from '../i18n'
import { t } from '../i18n/column'
import { closeDialog } from '../state/dialogs'
import { Dialog } from '../ui/dialog'
import { FormError } from '../ui/form_error'
import { openCard } from '../words/paper_cards'
import { cardText } from './card_texts'
import type { Card } from './markdown'

type Markdown = typeof import('./markdown')

/** A paper's card, as it stands in docs/papers, or in docs/zh for readers of Chinese. */
export function CardDialog() {
  const [read, setRead] = useState<{ card: Card; Blocks: Markdown['Blocks'] } | null>(null)
  const [error, setError] = useState<unknown>(null)
  const tongue = language.value
  useEffect(() => {
    Promise.all([cardText(openCard.value, tongue), import('./markdown')]).then(
      ([text, { readCard, Blocks }]) => setRead({ card: readCard(text), Blocks }),
      setError,
    )
  }, [tongue])
  return (
    <Dialog
      title={read?.card.title ?? t('papers.title')}
      onClose={closeDialog}
      testId="card-dialog"
      wide
    >
      {error !== null && <FormError error={error} />}
      {!read && error === null && <p role="status">{t('common.working')}</p>}
      {read && (
        <article class="card" lang={tongue}>
          <read.Blocks tokens={read.card.body} />
        </article>
      )}
    </Dialog>
  )
}
