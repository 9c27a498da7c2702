/** The readings of a paper, on a planner and among the claims of a question. */
import type { PaperReading } from '@pkg/formicarium'

export const enReadings = {
  title: 'Reading',
  /** Of an entry, for screen readers. */
  of: 'Reading of {{name}}',
  names: {
    printed: 'as printed',
    'as-read': 'as we read it',
    'second-reading': 'second reading',
  } satisfies Record<PaperReading, string>,
  defaults: 'The defaults: formulas mean what the paper’s own text says.',
  own: 'Own values: no reading as a whole.',
  noReading: 'The values are none of these readings as a whole.',
  all: 'All',
  claims: 'Claims by reading',
  claimsHint:
    'A row is what is claimed, a column one way to read the paper. Each is judged by itself; effects are changes against the baseline: below 0 is less.',
  measure: 'Measure',
  /** Of a claim, behind its measure. */
  ofClaim: '{{claim}} · {{reading}}',
}
