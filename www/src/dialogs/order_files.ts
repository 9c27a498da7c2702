/** The best order and the run as files; places are numbered from 1, as in instances. */
import type { OrderBound } from '@pkg/formicarium'
import { download } from '../state/export_files'
import type { OrderPlay } from '../state/order_play'

const stem = ({ facts, instance }: OrderPlay) =>
  (facts.peek().name || instance.name)
    .replace(/\.\w+$/, '')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-|-$/g, '') || 'order'

const fromOne = (order: number[]) => order.map((place) => place + 1)

/** One line a place. */
export function saveOrder(play: OrderPlay): void {
  const order = play.summary.peek()?.best?.order ?? []
  const { at } = play.facts.peek()
  const head = at ? 'position,place,x,y' : 'position,place'
  const rows = order.map((place, i) => [i + 1, place + 1, ...(at?.[place] ?? [])].join())
  download(`${stem(play)}-order.csv`, `${[head, ...rows].join('\n')}\n`, 'text/csv')
}

const boundOf = ({ lower_bound, best, complete, trees }: OrderBound) => ({
  lower_bound,
  cost: best.cost,
  complete,
  trees,
  places: fromOne(best.order),
})

/** As the command line prints it (docs/formats.md). */
export function saveRun(play: OrderPlay): void {
  const summary = play.summary.peek()
  if (!summary?.best) return
  const { name, comment, places, weight_type, exact, listed_optimum, tour } = play.facts.peek()
  const { open, seed, params } = play.settings.peek()
  const bound = play.bound.peek()
  const { gap, improvements, digest, best, iteration_of_best: iteration } = summary
  const order = {
    format: 'formicarium/order@1',
    name,
    comment,
    places,
    weight_type,
    closed: !open,
    params,
    exact: exact && { cost: exact.cost, places: fromOne(exact.order) },
    // As the command line tells it: at its end.
    bound: bound?.finished ? boundOf(bound) : undefined,
    listed_optimum,
    tour: tour && { file: play.tour?.name, cost: tour.cost },
    runs: [
      { seed, cost: best.cost, iteration, gap, places: fromOne(best.order), improvements, digest },
    ],
  }
  download(`${stem(play)}-run.json`, `${JSON.stringify(order, null, 2)}\n`, 'application/json')
}
