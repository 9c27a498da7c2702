/** The gallery of lessons: a picture, a title and a line of each, and what opens it, links to it, or saves it. */
import '../styles/lessons.css'
import { FileDown, Link } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { t } from '../i18n/lessons'
import type { Scenario } from '../model/session'
import { guide, notifyError } from '../state'
import { closeDialog } from '../state/dialogs'
import { download } from '../state/export_files'
import {
  LESSON_IDS,
  lessonAddress,
  lessonFile,
  lessonSession,
  lessonWords,
  openLesson,
} from '../state/gallery_lessons'
import { IconButton } from '../ui/buttons'
import { copyText } from '../ui/copy_text'
import { Dialog } from '../ui/dialog'
import { FormError } from '../ui/form_error'
import { MapPicture } from './map_picture'

export function Gallery() {
  const [error, setError] = useState<unknown>(null)
  const open = (id: string) => openLesson(id).then(closeDialog, setError)
  return (
    <Dialog title={t('lessons.title')} onClose={closeDialog} testId="lessons-dialog" wide>
      <p class="hint">{t('lessons.about')}</p>
      {error !== null && <FormError error={error} />}
      <ol class="lessons">
        {LESSON_IDS.map((id, at) => (
          <LessonRow key={id} id={id} number={at + 1} open={() => open(id)} />
        ))}
      </ol>
    </Dialog>
  )
}

interface RowProps {
  id: string
  number: number
  open: () => void
}

function LessonRow({ id, number, open }: RowProps) {
  const { title, line } = lessonWords(id)
  const save = async () =>
    download(`${id}.experiment.json`, await lessonFile(id), 'application/json')
  return (
    <li class="lesson-row" data-current={guide.value === id}>
      <button
        type="button"
        class="lesson-open"
        aria-current={guide.value === id}
        data-testid={`lesson-${id}`}
        onClick={open}
      >
        <span class="lesson-picture">
          <Picture id={id} />
        </span>
        <span class="lesson-words">
          <span class="lesson-number">{t('lessons.number', { number })}</span>
          <strong>{title}</strong>
          <span class="hint">{line}</span>
        </span>
      </button>
      <span class="lesson-more">
        <IconButton
          icon={Link}
          label={t('lessons.copy')}
          tone="quiet"
          size={16}
          testId={`lesson-link-${id}`}
          onClick={() => copyText(lessonAddress(id))}
        />
        <IconButton
          icon={FileDown}
          label={t('lessons.file')}
          tone="quiet"
          size={16}
          testId={`lesson-file-${id}`}
          onClick={() => save().catch(notifyError)}
        />
      </span>
    </li>
  )
}

/** Its map; the place is kept until it has been fetched, and stays empty if it cannot be. */
function Picture({ id }: { id: string }) {
  const [map, setMap] = useState<Scenario | null>(null)
  useEffect(() => {
    lessonSession(id).then(
      ({ scenario }) => setMap(scenario),
      () => {},
    )
  }, [id])
  if (!map) return null
  const { width, height } = map.spec
  return (
    <span class="lesson-map" style={{ '--aspect': width / height }}>
      <MapPicture map={map} ends />
    </span>
  )
}
