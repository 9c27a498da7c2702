/** Which planners fit the maps of the draft. */
import type { CatalogEntry } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import { whyNot } from '../../words/planner_words'
import { maps } from './draft'

/** Why a planner cannot run on all of the maps. */
export function whyNotHere(entry: CatalogEntry): string | null {
  for (const { name, scenario } of maps.value) {
    const why = whyNot(entry, scenario)
    if (why !== null) return maps.value.length > 1 ? t('lab.build.onMap', { map: name, why }) : why
  }
  return null
}
