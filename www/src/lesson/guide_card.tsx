/** The card of a lesson of the gallery: what it is about, its question, and the answer, which unfolds when it is asked for. */
import '../styles/guide_card.css'
import { ChevronRight } from 'lucide'
import { useEffect } from 'preact/hooks'
import { t } from '../i18n/lessons'
import { announce, guide, notifyError } from '../state'
import { show } from '../state/dialogs'
import { type LessonWords, lessonAfter, lessonWords, openLesson } from '../state/gallery_lessons'
import { Button } from '../ui/buttons'
import { CardFrame } from './card'

export function GuideCard({ id }: { id: string }) {
  const words = lessonWords(id)
  useEffect(() => {
    announce(`${words.title}: ${words.question}`)
  }, [id])
  const next = lessonAfter(id)
  const leave = () => {
    guide.value = null
  }
  return (
    <CardFrame title={words.title} line={words.question} testId="guide" onClose={leave}>
      <p>{words.note}</p>
      <section class="guide-question" aria-label={t('lessons.guess')}>
        <strong>{t('lessons.guess')}</strong>
        <p>{words.question}</p>
      </section>
      <Answer key={id} words={words} />
      <div class="card-actions guide-actions">
        <Button
          label={t('lessons.all')}
          tone="quiet"
          testId="guide-all"
          onClick={() => show('lessons')}
        />
        {next && (
          <Button
            label={t('lessons.next')}
            icon={ChevronRight}
            testId="guide-next"
            onClick={() => openLesson(next).catch(notifyError)}
          />
        )}
      </div>
    </CardFrame>
  )
}

/** Folded until it is asked for, and again with the next lesson. */
function Answer({ words }: { words: LessonWords }) {
  return (
    <details class="guide-answer" data-testid="guide-answer">
      <summary>{t('lessons.answer')}</summary>
      {words.answer.split('\n').map((paragraph) => (
        <p key={paragraph}>{paragraph}</p>
      ))}
      <p class="hint">{words.source}</p>
    </details>
  )
}
