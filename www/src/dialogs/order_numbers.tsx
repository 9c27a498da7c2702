/** What is known of an order problem, and what the ants have reached. */
import type { OrderBound } from '@pkg/formicarium'
import { t } from '../i18n/dialogs'
import { relativeGap } from '../model/gap'
import type { OrderPlay } from '../state/order_play'

const rounded = (cost: number) => String(Number(cost.toFixed(3)))

/** Of a bound nothing may be rounded up, of the gap above it nothing down. */
const atLeast = (bound: number) => String(Math.floor(1e3 * bound) / 1e3)

type Row = [key: string, label: string, value: string, note?: string]

/** What a search has found and proven. */
function boundRows(bound: OrderBound | null): Row[] {
  const labels = { search: t('order.search'), bound: t('order.bound') }
  if (!bound)
    return [
      ['search', labels.search, '–'],
      ['bound', labels.bound, '–'],
    ]
  const { lower_bound: lower, best, complete, trees } = bound
  const percent = (Math.ceil(1e4 * relativeGap(best.cost, lower)) / 100).toFixed(2)
  // Of nothing there is no share.
  const note = complete || lower <= 0 ? 'order.trees' : 'order.treesShort'
  return [
    ['search', labels.search, rounded(best.cost)],
    ['bound', labels.bound, atLeast(lower), t(note, { count: trees, percent })],
  ]
}

export function OrderNumbers({ play }: { play: OrderPlay }) {
  const facts = play.facts.value
  const summary = play.summary.value
  const bound = play.bound.value
  const { exact, listed_optimum: listed, tour, most_proven: most } = facts
  const proven = exact ?? (bound?.complete ? bound.best : null)
  const rows: Row[] = [
    ['name', t('order.name'), facts.name || play.instance.name, facts.comment],
    ['weights', t('order.weights'), facts.weight_type],
    [
      'exact',
      t('order.exact'),
      proven ? t('order.proven', { cost: rounded(proven.cost) }) : t('order.unproven', { most }),
    ],
  ]
  // In their place from the beginning: nothing moves when they come.
  if (!exact) rows.push(...boundRows(bound))
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
