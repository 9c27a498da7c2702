/** The path by hand on the map. */
import type { Cell } from '../model/cell'
import type { DrawnPath } from '../model/lesson'
import type { CanvasSize } from '../stage/panel_view'
import { lessonMode, slotColour } from '../state'
import { HAND_SLOT, measured } from './hand_panel'
import { lineOn, pointOn } from './map_lines'
import { Overlay } from './overlay'

export function HandLine({ drawn: { path }, size }: { drawn: DrawnPath; size: CanvasSize }) {
  const [x, y] = pointOn(size, path.at(-1) ?? [0, 0])
  const line = lineOn(size, clear(path, lessonMode.value !== 'draw'))
  const flawed = (measured.value?.found?.flaw ?? null) !== null
  return (
    <Overlay
      size={size}
      class={flawed ? 'hand-line flawed' : 'hand-line'}
      testId="hand-line"
      colour={slotColour(HAND_SLOT)}
    >
      <polyline class="halo" points={line} />
      <polyline class="line" points={line} />
      {lessonMode.value === 'draw' && <circle cx={x} cy={y} r={5} />}
    </Overlay>
  )
}

/** Cells from the middle of a marker to its rim. */
const RIM = 0.45

/** Begins and, done, ends at the rim of the markers of start and goal, which stay in sight. */
function clear(path: readonly Cell[], done: boolean): readonly Cell[] {
  const last = path.length - 1
  if (last < 1) return path
  return path.map((cell, i) => {
    const next = i === 0 ? path[1] : i === last && done ? path[last - 1] : null
    return next ? towards(cell, next) : cell
  })
}

function towards([x, y]: Cell, [toX, toY]: Cell): Cell {
  const share = RIM / Math.max(1, Math.hypot(toX - x, toY - y))
  return [x + share * (toX - x), y + share * (toY - y)]
}
