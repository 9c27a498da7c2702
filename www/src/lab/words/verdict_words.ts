/** The engine's words about verdicts in the reader's language. */
import { t } from '../../i18n/lab'

/** As src/comparison/verdict.rs has them; what is not among them is shown as it is. */
const WHYS = {
  'one of the two cannot be run': 'notRun',
  'the baseline finds no path in half of its runs or more': 'noBaseline',
  'too few runs to compare': 'fewRuns',
  "nearly all of the baseline's runs are optimal already": 'noRoom',
} as const

/** The same, said since there are facts and running times. */
const WHYS_OF_CLAIMS = {
  'the map contradicts what the publication says of its own': 'contradicted',
  'an instance before it is the same map': 'sameMap',
  'in many runs of one of the two the best is of its first stage': 'firstStage',
  'the two make different things small': 'otherObjective',
  'no target is known': 'noTarget',
  'the effort of a run is not known': 'noEffort',
  'no run of either reaches the target': 'neitherReaches',
} as const

/** Said since results from elsewhere may be impossible. */
const IMPOSSIBLE = 'runs of one of the two are impossible on this map'

export function whyWords(why: string): string {
  if (why === IMPOSSIBLE) return t('lab.matrix.whyImpossible')
  const ofClaims = why in WHYS_OF_CLAIMS ? WHYS_OF_CLAIMS[why as keyof typeof WHYS_OF_CLAIMS] : null
  if (ofClaims) return t(`lab.claims.whys.${ofClaims}`)
  const known = why in WHYS ? WHYS[why as keyof typeof WHYS] : null
  return known ? t(`lab.results.whys.${known}`) : why
}
