/** `t` for the table of numbers, whose explanations come with it; their Chinese comes with that of the page. */
import { addEnglish, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enMetricHints } from './en/metric_hints'

addEnglish(enMetricHints)

export const t = tOfPage as (
  key: TextKey | KeyOf<typeof enMetricHints>,
  args?: Record<string, unknown>,
) => string
