/** Where the cursor of the profile is: how high each path lies there, and on which cell. */
import '../styles/charts.css'
import { numbers } from '../i18n'
import { t } from '../i18n/reading'
import type { Cell } from '../model/cell'
import { panelTitle } from '../words/planner_words'
import { nearest, type Profile } from './profile_data'

interface Point {
  altitude: number
  cell: Cell
}

/** Null beyond the end of the path. */
export function pointAt(profile: Profile, distance: number): { point: Point | null } {
  const last = profile.distances.at(-1) ?? 0
  const index = nearest(profile, distance)
  const [altitude, cell] = [profile.altitudes[index], profile.cells[index]]
  if (distance > last || altitude === undefined || !cell) return { point: null }
  return { point: { altitude, cell } }
}

interface OfPanel {
  panelId: number
  colour: string
  point: Point | null
}

const metres = (value: number) => t('lengths.metres', { value: numbers.value.metres.format(value) })

export function pointInWords({ panelId, point }: OfPanel): string {
  const planner = panelTitle(panelId)
  if (!point) return `${planner}: –`
  const [x, y] = point.cell
  const altitude = numbers.value.metres.format(point.altitude)
  return t('cursor.altitudeOf', { planner, altitude, x, y })
}

interface ProfileReadoutProps {
  at: string
  distance: number
  points: OfPanel[]
}

export function ProfileReadout({ at, distance, points }: ProfileReadoutProps) {
  return (
    <div class="chart-readout" data-testid="profile-readout" data-distance={distance}>
      <table>
        <thead>
          <tr>
            <th scope="col">{at}</th>
            <th scope="col">{t('cursor.altitude')}</th>
            <th scope="col">{t('cursor.cell')}</th>
          </tr>
        </thead>
        <tbody>
          {points.map(({ panelId, colour, point }) => (
            <tr key={panelId} style={{ '--panel-colour': colour }}>
              <th scope="row">
                <span class="line-sample best" aria-hidden="true" />
                {panelTitle(panelId)}
              </th>
              <td>{point ? metres(point.altitude) : '–'}</td>
              <td>{point ? point.cell.join(', ') : '–'}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  )
}
