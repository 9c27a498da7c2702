/** How many runs there are, told apart as the engine tells them apart in captions of result files. */
import { t } from '../../i18n/lab'

/** Of planners that need no seeds; empty where there are none. */
export const alikeWords = (count: number) => (count > 0 ? t('lab.matrix.alike', { count }) : '')

/** What the bar says beside the number of runs. */
export function countWords({ alike, elsewhere }: { alike: number; elsewhere: number }): string[] {
  return [
    ...(alike > 0 ? [t('lab.matrix.alikeShort', { count: alike })] : []),
    ...(elsewhere > 0 ? [t('lab.matrix.elsewhere', { count: elsewhere })] : []),
  ]
}
