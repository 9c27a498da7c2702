/** What is written on frames and steps: above all who runs, and what has been reached. */
import { numbers } from '../i18n'
import { t } from '../i18n/film'
import { caption } from '../state'
import { gapShown } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import type { CopiedRun } from './copied_race'
import type { RaceLink } from './link_of_race'

/** Moves since the beginning, where they are what is counted. */
export function reachedWords(run: CopiedRun, moves: number | null): string {
  const { whole } = numbers.peek()
  const { summary, gap, isSearch } = run
  const reached = summary.metrics?.length
  const when =
    moves !== null
      ? t('film.move', { move: whole.format(moves) })
      : isSearch
        ? null
        : t('film.iteration', { iteration: whole.format(summary.iteration) })
  const what =
    reached === undefined
      ? t(summary.status === 'no-path' ? 'film.never' : 'film.noPath')
      : lengthShown(reached)
  return [when, what, gap === null ? null : gapShown(gap)]
    .filter((part) => part !== null)
    .join(' · ')
}

/** The session's title and note, each as long as it is; none where there is none. */
export function titleLines(): string[] {
  const { title, note } = caption.peek()
  return [title, note].map((text) => text.replace(/\s+/g, ' ').trim()).filter((text) => text !== '')
}

/** What stands beside a code or, where there is none, why. */
export function codeWords({ link, code }: RaceLink): string[] {
  if (code) return [t('film.scan'), `${location.host}${location.pathname}`]
  return [t(link === null ? 'film.noLink' : 'film.comment')]
}
