/** The charts beside or below the maps: one of the things that a frame may ask for. */
import '../../styles/column_part.css'
import { Charts } from '../../charts/charts'

export function ChartsPlace() {
  return (
    <div class="embedded-charts">
      <Charts />
    </div>
  )
}
