/** What each entry's front comes to; it says in words what the picture shows. */
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { inTurn, listed, saying } from '../../i18n/lists'
import type { EntryFront, MapAnalysis, MapFronts } from '../../model/analysis'
import { sideWords, volume, writer } from '../figures/fronts'
import { dash, labelOf, measureWords, share } from '../words/numbers'
import { dotColour } from './choices'

const COLUMNS = ['volume', 'share', 'joint', 'alone', 'own', 'told'] as const

interface TableProps {
  map: MapAnalysis
  fronts: MapFronts
}

export function FrontsTable({ map, fronts }: TableProps) {
  const most = Math.max(...fronts.entries.map(({ hypervolume }) => hypervolume ?? -1))
  const caption = t('lab.fronts.caption', { map: map.name })
  return (
    <>
      <p class="hint" data-testid="fronts-about">
        {about(fronts)}
      </p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it */}
      <section class="result-scroll" tabIndex={0} aria-label={caption}>
        <table class="result-table" data-testid="fronts-table">
          <caption class="visually-hidden">{caption}</caption>
          <thead>
            <tr>
              <th scope="col">{t('lab.results.columns.entry')}</th>
              {COLUMNS.map((column) => (
                <th key={column} scope="col">
                  {t(`lab.fronts.columns.${column}`)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {fronts.entries.map((front) => (
              <Row key={front.entry} map={map} front={front} most={most} />
            ))}
            <tr class="fronts-joint" data-testid="fronts-joint">
              <th scope="row">{t('lab.fronts.together')}</th>
              <td>{dash(fronts.joint_hypervolume, volume)}</td>
              <td>–</td>
              <td>{whole(fronts.joint_points)}</td>
              <td colSpan={3} />
            </tr>
          </tbody>
        </table>
      </section>
      <ul class="footnotes">
        <li>{t('lab.fronts.how')}</li>
        {fronts.entries.some(({ impossible }) => impossible > 0) && (
          <li>{t('lab.matrix.markNote')}</li>
        )}
      </ul>
    </>
  )
}

const whole = (count: number) => numbers.value.whole.format(count)

/** Over which measures, and against which point. */
function about(fronts: MapFronts): string {
  const sides = inTurn(fronts.measures.map((_, place) => sideWords(fronts, place)))
  if (fronts.reference.length === 0) return t('lab.fronts.over', { measures: sides })
  const at = fronts.reference.map((value, place) => {
    const measure = fronts.measures[place]
    return saying(measureWords(measure ?? 'length'), writer(measure)(value))
  })
  return t('lab.fronts.overAgainst', { measures: sides, reference: listed(at) })
}

interface RowProps {
  map: MapAnalysis
  front: EntryFront
  most: number
}

function Row({ map, front, most }: RowProps) {
  const entry = map.entries[front.entry]
  if (!entry) return null
  const { hypervolume, own, joint, alone, told, runs } = front
  const isMost = hypervolume !== null && hypervolume === most && most > 0
  return (
    <tr
      style={{ '--panel-colour': dotColour(entry, front.entry) }}
      data-testid={`fronts-row-${entry.id}`}
    >
      <th scope="row">
        <span class="panel-dot" aria-hidden="true" />
        {labelOf(entry)}
      </th>
      <td>{isMost ? <strong>{volume(hypervolume)}</strong> : dash(hypervolume, volume)}</td>
      <td>{dash(front.share, share)}</td>
      <td>{whole(joint)}</td>
      <td>{whole(alone)}</td>
      <td>{whole(own)}</td>
      <td>{runs === 0 ? '–' : t('lab.results.of', { part: told, whole: runs })}</td>
    </tr>
  )
}
