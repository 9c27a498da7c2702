/** A tour leg by leg: what was planned, what is walked, and what it weighs. */
import { numbers } from '../i18n'
import { t } from '../i18n/column'
import { goalName, goalWeight } from '../model/goals'
import { type Panel, panelById, scenario, shownOf } from '../state'
import { lengthNumber, withUnit } from '../words/metres'

export default function Legs({ panel }: { panel: Panel }) {
  const now = panelById(panel.id)
  const tour = now && shownOf(now).summary?.tour
  const spec = scenario.value?.spec
  if (!tour || !spec) return null
  const stops = [t('stage.start'), ...tour.order.map((goal) => goalName(spec, goal))]
  const weightOf = (leg: number) => {
    const goal = spec.goals[tour.order[leg] ?? -1]
    return goal ? goalWeight(goal) : Number.NaN
  }
  const shown = (value: number | null | undefined) => (value == null ? '–' : lengthNumber(value))
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="legs" tabIndex={0} aria-label={t('legs.title')} data-testid="legs">
      <table class="metrics">
        <thead>
          <tr>
            <th scope="col">{t('legs.leg')}</th>
            <th scope="col">{withUnit(t('legs.planned'))}</th>
            <th scope="col">{withUnit(t('legs.walked'))}</th>
            <th scope="col">
              <i>b</i>
            </th>
            <th scope="col" title={t('legs.weightHint')}>
              {withUnit('R')}
            </th>
          </tr>
        </thead>
        <tbody>
          {tour.order.map((_, leg) => {
            const walked = tour.walked[leg]
            return (
              <tr key={leg}>
                <th scope="row">{`${stops[leg]} → ${stops[leg + 1]}`}</th>
                <td>{shown(tour.planned[leg])}</td>
                <td>{shown(walked)}</td>
                <td>{numbers.value.weight.format(weightOf(leg))}</td>
                <td>{shown(walked === undefined ? null : walked * weightOf(leg))}</td>
              </tr>
            )
          })}
          <tr class="total">
            <th scope="row">{t('legs.total')}</th>
            <td>{shown(tour.planned_length)}</td>
            <td>{shown(sum(tour.walked))}</td>
            <td />
            <td>{shown(tour.walked_weight)}</td>
          </tr>
        </tbody>
      </table>
    </section>
  )
}

/** Null before anything was walked. */
function sum(lengths: number[]): number | null {
  return lengths.length === 0 ? null : lengths.reduce((total, length) => total + length, 0)
}
