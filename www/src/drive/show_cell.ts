/** Brings a cell of a magnified map into sight. */
import type { Cell } from '../model/cell'
import { reveal, viewpoint } from '../model/viewpoint'
import { scenario } from '../state'
import { drivingPanel } from './drive'

export function showCell(cell: Cell): void {
  const stage = document.querySelector(`[data-testid="stage-${drivingPanel.peek()?.id}"]`)
  const spec = scenario.peek()?.spec
  if (!stage || !spec) return
  const dpr = devicePixelRatio
  const size = { width: stage.clientWidth * dpr, height: stage.clientHeight * dpr, dpr }
  viewpoint.value = reveal(viewpoint.peek(), cell, size, spec)
}
