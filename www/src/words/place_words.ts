/** Where a cell lies in the world, in words. */
import { t } from '../i18n/reading'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { fromCorner, placeOf } from '../model/world'

/** Below this many metres a cell, its middle needs a third decimal. */
const FINE = 0.1

/** From the map's lower left corner where its place is not known, on a plane; a terrain tells the height of a cell. */
export function placeWords({ spec }: Scenario, cell: Cell): string | null {
  const place = placeOf(spec, cell)
  if (!place && spec.terrain) return null
  const [x, y] = (place ?? fromCorner(spec, cell)).map((metres) =>
    metres.toFixed(spec.resolution < FINE ? 3 : 2),
  )
  return t(place ? 'lengths.place' : 'lengths.fromCorner', { x, y })
}
