/** What a lesson puts on one panel's map: the path by hand, the followed ant, the stop that was met. */
import type { ReadonlySignal } from '@preact/signals'
import { useLayoutEffect, useRef } from 'preact/hooks'
import type { CanvasSize, Cursor } from '../stage/panel_view'
import { lesson, lessonMode } from '../state'
import { antHandlers } from './ant_input'
import { AntTrail } from './ant_trail'
import { drawHandlers } from './draw_input'
import { followed } from './follow'
import { guessHandlers } from './guess_input'
import { HandLine } from './hand_line'
import { listenToMap, type MapHandlers } from './map_input'
import { StopChips } from './stop_chips'

interface OnMapProps {
  panelId: number
  size: ReadonlySignal<CanvasSize>
  cursor: ReadonlySignal<Cursor | null>
}

export function OnMap({ panelId, size, cursor }: OnMapProps) {
  const anchor = useRef<HTMLSpanElement>(null)
  // At once: keys that are pressed as a card appears are the lesson's.
  useLayoutEffect(() => {
    const holder = anchor.current?.parentElement
    if (!holder) return
    return listenToMap(holder, size, cursor, () => handlersOf(panelId))
  }, [panelId])
  const mode = lessonMode.value
  const isHere = followed.value?.panelId === panelId
  return (
    <>
      <span
        ref={anchor}
        class="lesson-anchor"
        data-mode={mode === 'drive' ? '' : (mode ?? '')}
        hidden
      />
      {lesson.value?.drawn && <HandLine drawn={lesson.value.drawn} size={size.value} />}
      {isHere && (mode === 'follow' || mode === 'guess') && <AntTrail size={size.value} />}
      <StopChips panelId={panelId} />
    </>
  )
}

/** Null where the map is used as ever. */
function handlersOf(panelId: number): MapHandlers | null {
  switch (lessonMode.peek()) {
    case 'follow':
      return antHandlers(panelId)
    case 'guess':
      return followed.peek()?.panelId === panelId ? guessHandlers : null
    case 'draw':
      return drawHandlers(panelId)
    default:
      return null
  }
}
