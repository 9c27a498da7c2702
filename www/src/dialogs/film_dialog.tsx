/** Films, moving pictures and slides of the race: fetched when somebody wants one. */
import { addFilmWords } from '../i18n/film'
import { addReadingWords } from '../i18n/reading'
import { lazily } from '../ui/lazily'

export const FilmDialog = lazily(async () => {
  const [{ FilmForm }] = await Promise.all([
    import('./film_form'),
    addFilmWords(),
    addReadingWords(),
  ])
  return FilmForm
})
