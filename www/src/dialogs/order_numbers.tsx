/** What is known of an order problem, and what the ants have reached. */
import { t } from '../i18n/dialogs'
import type { OrderPlay } from '../state/order_play'

const rounded = (cost: number) => String(Number(cost.toFixed(3)))

export function OrderNumbers({ play }: { play: OrderPlay }) {
  const facts = play.facts.value
  const summary = play.summary.value
  const { exact, listed_optimum: listed, tour, most_proven: most } = facts
  const rows: [key: string, label: string, value: string, note?: string][] = [
    ['name', t('order.name'), facts.name || play.instance.name, facts.comment],
    ['weights', t('order.weights'), facts.weight_type],
    [
      'exact',
      t('order.exact'),
      exact ? t('order.proven', { cost: rounded(exact.cost) }) : t('order.unproven', { most }),
    ],
  ]
  if (listed !== null)
    rows.push(['listed', t('order.listed'), rounded(listed), facts.listed_source])
  if (tour && play.tour)
    rows.push(['tour', t('order.tour', { file: play.tour.name }), rounded(tour.cost)])
  const best = summary?.best
  const gap = summary?.gap ?? null
  rows.push(['best', t('order.best'), best ? rounded(best.cost) : '–'])
  if (exact || listed !== null)
    rows.push([
      'gap',
      t(exact ? 'order.aboveProven' : 'order.aboveListed'),
      gap === null ? '–' : t('order.gap', { percent: (100 * gap).toFixed(2) }),
    ])
  rows.push(
    ['found', t('order.found'), String(summary?.iteration_of_best ?? '–')],
    [
      'iteration',
      t('order.iteration'),
      summary ? t('order.of', { now: summary.iteration, all: summary.budget }) : '–',
    ],
  )
  return (
    <dl class="raster-facts map-facts">
      {rows.map(([key, label, value, note]) => (
        <div key={key}>
          <dt>{label}</dt>
          <dd data-testid={`order-${key}`}>
            {value}
            {note && <span class="hint">{note}</span>}
          </dd>
        </div>
      ))}
    </dl>
  )
}
