/** What the comparison says of the smooth curves of all panels. */
import { t } from '../i18n/column'
import { type Panel, scenario } from '../state'
import { curveOf } from '../state/curves'
import { lengthNumber } from '../words/metres'
import { bestOf, significant } from '../words/metric_rows'
import type { Measure, MeasureCell } from './measures'

type Curve = NonNullable<ReturnType<typeof curveOf>>

/** Those that some panel has. */
export function curveMeasures(all: Panel[]): Measure[] {
  const rule = scenario.value?.spec.vehicle.smoothing
  const curves = rule ? all.map(curveOf) : []
  if (curves.every((curve) => curve === null)) return []
  const length = numeric(curves, ({ length }) => length, lengthNumber)
  const curvature = numeric(curves, (curve) => curve.largest_curvature ?? null, significant)
  return [
    { id: 'curveLength', wordy: false, isLength: true, cells: length },
    { id: 'curveCurvature', wordy: false, cells: curvature },
    ...(rule?.max_curvature ? [boundMeasure(curves)] : []),
  ]
}

function numeric(
  curves: (Curve | null)[],
  read: (curve: Curve) => number | null,
  format: (value: number) => string,
): MeasureCell[] {
  const values = curves.map((curve) => (curve?.is_curve ? read(curve) : null))
  const best = bestOf(values, 'lower')
  return values.map((value, index) => ({
    text: value === null ? '–' : format(value),
    value,
    better: best.has(index),
    ...(curves[index]?.is_curve === false && { why: t('metrics.noCurve') }),
  }))
}

function boundMeasure(curves: (Curve | null)[]): Measure {
  const cells = curves.map((curve) => {
    if (!curve) return { text: '–' }
    if (!curve.is_curve) return { text: '–', why: t('metrics.noCurve') }
    return { text: t(curve.meets_bound ? 'metrics.bound.met' : 'metrics.bound.missed') }
  })
  return { id: 'curveBound', wordy: true, cells }
}
