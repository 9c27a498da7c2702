/** Makes the view that a panel's worker draws with. */
import type { Cell } from '../model/cell'
import { goalName } from '../model/goals'
import type { PanelView } from '../model/messages'
import { type CanvasSize, type Placement, placement, viewpoint } from '../model/viewpoint'
import { layer, layerEnds, panelColour, scenario, showAnts, showPath, theme } from '../state'
import { inRelief, showContours } from '../state/relief'

export type { CanvasSize }

/** Where the cell cursor is, and whether keys or the pointer put it there. */
export interface Cursor {
  cell: Cell
  byKeys: boolean
}

/** Read inside an effect: it depends on every signal a picture depends on. */
export function lookAt(panelId: number, size: CanvasSize, cursor: Cursor | null): PanelView {
  return {
    ...size,
    ...place(size),
    layer: layer.value,
    ends: layerEnds.value,
    showAnts: showAnts.value,
    showPath: showPath.value,
    showContours: showContours.value,
    hidden: inRelief.value,
    theme: theme.value,
    colour: panelColour(panelId),
    goalNames: names(),
    cursor: cursor?.cell ?? null,
    cursorFocus: cursor?.byKeys ?? false,
  }
}

function names(): string[] {
  const spec = scenario.value?.spec
  return spec ? spec.goals.map((_, index) => goalName(spec, index)) : []
}

/** Where the present scenario lies on a canvas of this size. */
export function place(size: CanvasSize): Placement {
  const map = scenario.value?.spec ?? { width: 1, height: 1 }
  return placement(viewpoint.value, size, map)
}
