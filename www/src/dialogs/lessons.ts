/** The gallery of lessons as a dialog: with its words a part of its own, as most visits do without it. */
import { addLessonsWords } from '../i18n/lessons'
import { lazily } from '../ui/lazily'

export const LessonsDialog = lazily(async () => {
  const [{ Gallery }] = await Promise.all([import('./lessons_dialog'), addLessonsWords()])
  return Gallery
})
