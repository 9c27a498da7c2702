/** A distribution in one line of a table: a dot a run, the optimum, and the published number among them. */

import { symbolPath } from '../../figures/point_symbols'
import { t } from '../../i18n/lab'
import type { EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { seriesOf } from '../figures/figure_style'
import { jitter } from '../figures/whiskers_and_jitter'
import { type ExactOptimum, labelOf, optimaOf } from '../words/numbers'

const [WIDTH, HEIGHT, EDGE] = [220, 34, 8]

/** One scale for all entries of a map. Pixels. */
export function stripScale(map: MapAnalysis): (value: number) => number {
  const values = map.entries.flatMap(({ values, published }) =>
    published ? [...values, published.value] : [],
  )
  const all = [...values, ...optimaOf(map).map(({ value }) => value)].filter(
    (value) => value !== null,
  )
  const [least, most] = [Math.min(...all), Math.max(...all)]
  const wide = most > least ? most - least : 1
  return (value) => EDGE + ((value - least) / wide) * (WIDTH - 2 * EDGE)
}

interface StripProps {
  entry: EntryAnalysis
  index: number
  scale: (value: number) => number
  optima: ExactOptimum[]
}

export function Strip({ entry, index, scale, optima }: StripProps) {
  const { colour } = seriesOf(index, '')
  const { published } = entry
  return (
    <svg
      class="strip"
      role="img"
      aria-label={t('lab.results.stripOf', { entry: labelOf(entry), count: entry.with_path })}
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      width={WIDTH}
      height={HEIGHT}
    >
      <path class="strip-line" d={`M0 ${HEIGHT - 2}H${WIDTH}`} />
      {optima.map(({ value }) => (
        <path key={value} class="strip-optimum" d={`M${scale(value)} 2V${HEIGHT - 2}`} />
      ))}
      {entry.values.map((value, i) =>
        value === null ? null : (
          <circle
            key={entry.seeds[i]}
            cx={scale(value)}
            cy={HEIGHT / 2 - 1 + 9 * jitter(entry.seeds[i] ?? i)}
            r="2.2"
            fill={colour}
            fill-opacity="0.55"
          />
        ),
      )}
      {published?.value != null && (
        <path
          class={published.impossible ? 'strip-published impossible' : 'strip-published'}
          d={symbolPath('diamond', 5)}
          transform={`translate(${scale(published.value)} ${HEIGHT / 2 - 1})`}
        />
      )}
    </svg>
  )
}
