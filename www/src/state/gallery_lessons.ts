/** The gallery of lessons: what opens one of them, in the reader's language. Fetched with the first lesson, or the list of them. */
import { batch, effect } from '@preact/signals'
import { LESSON_IDS, lessonText, measuredIn } from '../gallery/lesson_files'
import { addLessonsWords, t } from '../i18n/lessons'
import type { Session } from '../model/session'
import { sessionFromFile, sessionToFile } from '../share/link'
import { pageAddress } from '../share/page_file'
import { goTo, place } from './address'
import { openText } from './files'
import { guide, LESSON_PREFIX } from './lesson'
import { showView } from './page_view'
import { loadSession } from './sessions'
import { engineVersion } from './store'

export { LESSON_IDS }

/** Texts of a lesson: all have the same ones, so one key stands for their type. */
type TextsOf = 'bridge'

/** In the reader's language. */
export interface LessonWords {
  title: string
  /** What it is about, in one line. */
  line: string
  /** Of the panels. */
  labels: string[]
  note: string
  question: string
  /** Paragraphs, one a line. */
  answer: string
  /** How its numbers were measured. */
  source: string
}

export function lessonWords(id: string): LessonWords {
  const numbers = measuredIn(id)
  const word = (key: 'title' | 'line' | 'labels' | 'note' | 'question' | 'answer') =>
    t(`lessons.each.${id as TextsOf}.${key}`, numbers)
  return {
    title: word('title'),
    line: word('line'),
    labels: word('labels').split('\n'),
    note: word('note'),
    question: word('question'),
    answer: word('answer'),
    source: t('lessons.measured', { ...numbers, id }),
  }
}

/** Null after the last one. */
export function lessonAfter(id: string): string | null {
  return LESSON_IDS[LESSON_IDS.indexOf(id) + 1] ?? null
}

/** Throws where there is no such lesson. With title, note, question and the names of its panels in the reader's language. */
export async function lessonSession(id: string): Promise<Session> {
  await addLessonsWords()
  if (!LESSON_IDS.includes(id)) throw unknown(id)
  const text = await lessonText(id)
  const { scenario, panels, lesson, ...session } = await sessionFromFile(text)
  const { title, note, question, labels } = lessonWords(id)
  const drawn = lesson?.drawn && { drawn: { ...lesson.drawn, label: t('lessons.cut') } }
  return {
    ...session,
    title,
    note: `${note}\n\n${question}`,
    panels: panels.map((panel, i) => ({ ...panel, label: labels[i] ?? null })),
    scenario: { ...scenario, spec: { ...scenario.spec, name: title } },
    ...(lesson && { lesson: { ...lesson, ...drawn } }),
  }
}

export async function lessonFile(id: string): Promise<string> {
  return sessionToFile(await lessonSession(id), engineVersion.peek())
}

export const lessonAddress = (id: string) => `${pageAddress()}${LESSON_PREFIX}${id}`

/** Opens a lesson as its link does. */
export const openLesson = (id: string) => openText(LESSON_PREFIX + id)

/** Puts its session on the page, at rest and without what was recorded: the question comes before the run. */
export function showLesson(id: string, session: Session): void {
  const panels = session.panels.map((panel) => ({ ...panel, result: null }))
  showView('race')
  batch(() => {
    loadSession({ ...session, panels })
    guide.value = id
  })
  goTo(LESSON_PREFIX + id, 'replace')
  leaveWithGuide()
}

const unknown = (id: string) => ({
  kind: 'unknown-lesson',
  field: 'lesson',
  message: t('lessons.unknown', { id: id.slice(0, 40) }),
  hint: t('lessons.unknownHint'),
  args: {},
})

let watching = false

/** Once the lesson has been left, a reload brings back what is on show, not the lesson. */
function leaveWithGuide(): void {
  if (watching) return
  watching = true
  effect(() => {
    if (guide.value === null && place.peek().startsWith(LESSON_PREFIX)) goTo('', 'replace')
  })
}
