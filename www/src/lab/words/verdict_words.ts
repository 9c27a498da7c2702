/** The engine's words about verdicts in the reader's language. */
import { t } from '../../i18n/lab'

/** As src/comparison/judge.rs has them; what is not among them is shown as it is. */
const WHYS = {
  'one of the two cannot be run': 'notRun',
  'the baseline finds no path in half of its runs or more': 'noBaseline',
  'too few runs to compare': 'fewRuns',
  "nearly all of the baseline's runs are optimal already": 'noRoom',
} as const

export function whyWords(why: string): string {
  const known = why in WHYS ? WHYS[why as keyof typeof WHYS] : null
  return known ? t(`lab.results.whys.${known}`) : why
}

/** Names of measures, as src/comparison/question.rs has them. */
const MEASURES = {
  length: 'length',
  cost: 'cost',
  turns: 'turns',
  'turn index V': 'turn-index',
  'weight R': 'weight',
  'iteration of best': 'iteration-of-best',
  'constructed paths to best': 'paths-to-best',
  'ant moves': 'ant-moves',
  'share of runs with a path': 'success',
  'share of runs with the optimum': 'optimal',
} as const

export function measureNamed(name: string): string {
  const known = name in MEASURES ? MEASURES[name as keyof typeof MEASURES] : null
  return known ? t(`lab.results.measures.${known}`) : name
}
