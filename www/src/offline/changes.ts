/** What a newer version of the page means for links that were made with this one. */
import { t } from '../i18n/offline'
import type { PageVersion } from '../model/kept_page'
import { catalog, panels } from '../state'
import { plannerName } from '../words/planner_words'

/** Planners that give something else, or are no longer there. */
export const changedPlanners = (used: PageVersion, newer: PageVersion) =>
  Object.keys(used.results).filter((id) => used.results[id] !== newer.results[id])

/** Which links are touched: those whose results came from planners that the newer engine computes differently. */
export function changesOf(used: PageVersion, newer: PageVersion): string {
  const changed = changedPlanners(used, newer)
  if (changed.length === 0) return t('offline.sameResults')
  const names = changed.map(nameOf).join(t('offline.comma'))
  const told = t('offline.otherResults', { names, count: changed.length })
  const here = panels.peek().filter(({ setup }) => changed.includes(setup.planner)).length
  return here === 0 ? told : told + t('offline.onThisPage', { count: here })
}

function nameOf(id: string): string {
  const entry = catalog.peek()?.planners.find((planner) => planner.id === id)
  return entry ? plannerName(entry) : id
}
