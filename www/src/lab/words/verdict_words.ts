/** The engine's words about verdicts in the reader's language. */
import { t } from '../../i18n/lab'

/** As src/comparison/judge.rs has them; what is not among them is shown as it is. */
const WHYS = {
  'one of the two cannot be run': 'notRun',
  'the baseline finds no path in half of its runs or more': 'noBaseline',
  'too few runs to compare': 'fewRuns',
  "nearly all of the baseline's runs are optimal already": 'noRoom',
} as const

/** Said since results from elsewhere may be impossible. */
const IMPOSSIBLE = 'runs of one of the two are impossible on this map'

export function whyWords(why: string): string {
  if (why === IMPOSSIBLE) return t('lab.matrix.whyImpossible')
  const known = why in WHYS ? WHYS[why as keyof typeof WHYS] : null
  return known ? t(`lab.results.whys.${known}`) : why
}
