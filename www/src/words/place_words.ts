/** Where a cell lies in the world, in words. */
import { t } from '../i18n'
import type { Cell } from '../model/cell'
import type { Scenario } from '../model/session'
import { placeOf } from '../model/world'

/** Below this many metres a cell, its middle needs a third decimal. */
const FINE = 0.1

/** Null where the map's place is not known. */
export function placeWords({ spec }: Scenario, cell: Cell): string | null {
  const place = placeOf(spec, cell)
  if (!place) return null
  const [x, y] = place.map((metres) => metres.toFixed(spec.resolution < FINE ? 3 : 2))
  return t('relief.place', { x, y })
}
