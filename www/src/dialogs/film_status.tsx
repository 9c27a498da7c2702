/** One line below the preview: how large it will be, how far it is, what has come of it. */
import { bitrateOf, type Encoding } from '../film/encode'
import { framesOf, secondsOf } from '../film/settings'
import { numbers } from '../i18n'
import { t } from '../i18n/film'
import { panels } from '../state'
import { type Draft, filmOf } from './film_draft'
import type { Work } from './film_work'

interface FilmStatusProps {
  work: Work
  draft: Draft
  encoding: Encoding | null | undefined
  tooLarge: boolean
}

export function FilmStatus({ work, draft, encoding, tooLarge }: FilmStatusProps) {
  if (work.phase === 'making') return <Progress {...work} isFilm={draft.what === 'film'} />
  if (work.phase === 'ready') return <Ready made={work.made} />
  if (panels.value.length === 0) return <Refusal words={t('film.noRun')} />
  if (tooLarge) return <Refusal words={t('film.tooLarge')} />
  if (draft.what !== 'film') return <Line words="" />
  if (encoding === null) return <Refusal words={t('film.noEncoder')} />
  return <Line words={encoding ? estimate(draft, encoding) : t('film.asking')} />
}

function estimate(draft: Draft, encoding: Encoding): string {
  const { whole, metres } = numbers.value
  const film = filmOf(draft)
  const seconds = secondsOf(film)
  return t('film.estimate', {
    frames: whole.format(framesOf(film)),
    seconds: metres.format(Math.round(10 * seconds) / 10),
    format: encoding.name,
    size: bytesShown((seconds * bitrateOf(film, film.rate)) / 8),
  })
}

const Line = ({ words }: { words: string }) => (
  <p class="hint film-status" role="status" data-testid="film-status">
    {words}
  </p>
)

const Refusal = ({ words }: { words: string }) => (
  <p class="banner film-status" role="status" data-testid="film-refusal">
    {words}
  </p>
)

interface ProgressProps {
  done: number
  frames: number
  isFilm: boolean
}

function Progress({ done, frames, isFilm }: ProgressProps) {
  const { whole } = numbers.value
  const words = t(isFilm ? 'film.progress' : 'film.progressSteps', {
    done: whole.format(done),
    frames: whole.format(frames),
  })
  const known = frames > 0
  return (
    <div class="film-status film-progress" data-testid="film-progress">
      <progress
        max={known ? frames : undefined}
        value={known ? done : undefined}
        aria-label={words}
      />
      <span class="hint">{known ? words : t('common.working')}</span>
    </div>
  )
}

function Ready({ made }: { made: Extract<Work, { phase: 'ready' }>['made'] }) {
  return (
    <p
      class={`film-status ${made.agreement === 'differs' ? 'banner' : 'hint'}`}
      role="status"
      data-testid="film-ready"
      data-agreement={made.agreement}
    >
      {t('film.ready', { size: bytesShown(made.file.size) })}{' '}
      {t(`film.agreement.${made.agreement}`)}
    </p>
  )
}

function bytesShown(bytes: number): string {
  const { whole, metres } = numbers.value
  if (bytes < 1e6) return `${whole.format(Math.ceil(bytes / 1e3))} kB`
  return `${metres.format(Math.round(bytes / 1e5) / 10)} MB`
}
