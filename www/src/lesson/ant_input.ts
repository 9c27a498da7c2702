/** Choosing an ant on the map. */
import { t } from '../i18n/lesson'
import type { Cell } from '../model/cell'
import { announce, panelById, plannerEntry } from '../state'
import { antNear, follow, followed, seen, whenSettled } from './follow'
import type { MapHandlers } from './map_input'

export function antHandlers(panelId: number): MapHandlers {
  const choose = (cell: Cell) => void chooseAt(panelId, cell)
  return { press: choose, enter: choose }
}

/** In another panel the ants there have to be asked for first. */
async function chooseAt(panelId: number, cell: Cell): Promise<void> {
  const family = plannerEntry(panelById(panelId)?.setup.planner ?? '')?.family
  if (family !== 'ant-colony') {
    announce(t('lesson.ant.noAnts'))
    return
  }
  if (followed.peek()?.panelId !== panelId) follow(panelId, 0)
  await whenSettled()
  const now = seen.peek()
  if (now?.panelId !== panelId) return
  const [x, y] = cell
  const ant = antNear(cell, now.ants)
  if (ant !== null) {
    follow(panelId, ant)
    announce(t('lesson.ant.chosen', { ant: ant + 1, x, y }))
  } else
    announce(t(now.ants.length === 0 ? 'lesson.ant.allAtStart' : 'lesson.ant.noneHere', { x, y }))
}
