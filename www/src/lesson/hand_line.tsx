/** The path by hand on the map. */
import type { DrawnPath } from '../model/lesson'
import type { CanvasSize } from '../stage/panel_view'
import { lessonMode, slotColour } from '../state'
import { HAND_SLOT, measured } from './hand_panel'
import { lineOn, pointOn } from './map_lines'
import { Overlay } from './overlay'

export function HandLine({ drawn: { path }, size }: { drawn: DrawnPath; size: CanvasSize }) {
  const [x, y] = pointOn(size, path.at(-1) ?? [0, 0])
  const flawed = (measured.value?.found?.flaw ?? null) !== null
  return (
    <Overlay
      size={size}
      class={flawed ? 'hand-line flawed' : 'hand-line'}
      testId="hand-line"
      colour={slotColour(HAND_SLOT)}
    >
      <polyline class="halo" points={lineOn(size, path)} />
      <polyline class="line" points={lineOn(size, path)} />
      {lessonMode.value === 'draw' && <circle cx={x} cy={y} r={5} />}
    </Overlay>
  )
}
