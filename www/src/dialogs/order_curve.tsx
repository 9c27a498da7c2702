/** The best cost over the iterations, as a line of steps; the optimum is dashed. */
import { t } from '../i18n/dialogs'
import type { OrderPlay } from '../state/order_play'

const WIDTH = 280
const HEIGHT = 64
const EDGE = 4

export function OrderCurve({ play }: { play: OrderPlay }) {
  const summary = play.summary.value
  const { exact, listed_optimum: listed } = play.facts.value
  const optimum = exact?.cost ?? listed
  const steps = summary?.improvements ?? []
  const first = steps[0]?.[1] ?? 1
  const least = Math.min(optimum ?? Number.POSITIVE_INFINITY, steps.at(-1)?.[1] ?? first)
  const span = first - least || 1
  const x = (iteration: number) =>
    EDGE + ((WIDTH - 2 * EDGE) * iteration) / Math.max(1, summary?.budget ?? 1)
  const y = (cost: number) => EDGE + ((HEIGHT - 2 * EDGE) * (first - cost)) / span
  const line = steps.map(
    ([iteration, cost], i) =>
      `${i === 0 ? 'M' : 'H'}${x(iteration)}${i === 0 ? ' ' : 'V'}${y(cost)}`,
  )
  const path = steps.length > 0 ? `${line.join('')}H${x(summary?.iteration ?? 0)}` : ''
  return (
    <svg
      class="order-curve"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={t('order.curve')}
      data-testid="order-curve"
    >
      {optimum !== null && optimum !== undefined && (
        <line class="optimum" x1={EDGE} x2={WIDTH - EDGE} y1={y(optimum)} y2={y(optimum)} />
      )}
      <path d={path} />
    </svg>
  )
}
