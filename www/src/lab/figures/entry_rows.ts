/** Figures with one row an entry: its name above its values, so that names may be long and the values have the whole width. */

import { FONT } from '../../figures/look'
import { shortened, widthOf } from '../../figures/svg'
import { t } from '../../i18n/lab'
import { MARGIN } from './draw_plot'
import type { Plot, Scene, Shown } from './figure'

/** Pixels. */
export const ROW = 62
const LABEL_FONT = `600 12px ${FONT}`
const ASIDE_FONT = `12px ${FONT}`

/** Parts of a row's height, from above. */
export const LABEL_AT = 0.2
export const MIDDLE = 0.66
export const HALF_BOX = 0.18

export interface RowText {
  label: string
  /** At the other end: what the row leaves out. */
  aside: string
  /** Of the aside; what is left out stands out. */
  tone?: 'plain'
}

/** How many runs found nothing; empty where all did. */
export function failures({ entry }: Shown): string {
  const failed = entry.runs - entry.with_path
  return failed === 0 ? '' : t('lab.results.failures', { count: failed, runs: entry.runs })
}

/** Around words that stand over lines: wide enough that no dot of a dotted one touches a letter. Pixels, half of them to be seen. */
const HALO = 7

/** Names and what is left out, in the corners of each row. */
export function rowTexts(plot: Plot, scene: Scene, rows: RowText[]) {
  const { look, width } = scene
  const room = width - MARGIN.right
  const text = (dy: number) =>
    ({ y: (_: RowText, i: number) => i + dy, lineAnchor: 'middle' }) as const
  const fitted = rows.map(({ label, aside, tone }) => {
    const taken = aside === '' ? 0 : widthOf(aside, ASIDE_FONT) + 12
    return {
      label: shortened(label, room - taken, LABEL_FONT),
      aside,
      colour: tone === 'plain' ? look.muted : look.bad,
    }
  })
  return [
    plot.ruleY(rows.slice(1), { y: (_, i) => i + 1, stroke: look.line }),
    plot.text(fitted, {
      ...text(LABEL_AT),
      frameAnchor: 'left',
      dx: -MARGIN.left,
      text: 'label',
      textAnchor: 'start',
      fontWeight: 600,
      fontSize: 12,
      fill: look.text,
      stroke: look.background,
      strokeWidth: HALO,
      className: 'row-labels',
    }),
    plot.text(fitted, {
      ...text(LABEL_AT),
      frameAnchor: 'right',
      text: 'aside',
      textAnchor: 'end',
      fontSize: 12,
      fill: 'colour',
      stroke: look.background,
      strokeWidth: HALO,
      className: 'row-asides',
    }),
  ]
}

/** The rows' own scale: one unit a row, from above. */
export const rowScale = (rows: number) =>
  ({ axis: null, domain: [0, rows], reverse: true }) as const
