/** A drive on its panel's map: the ground under it, what moves, and the robot. */
import type { ReadonlySignal } from '@preact/signals'
import { useLayoutEffect, useRef } from 'preact/hooks'
import { listenToMap } from '../lesson/map_input'
import type { CanvasSize, Cursor } from '../stage/panel_view'
import { inRelief, pressed } from '../state'
import { drivingPanel } from './drive'
import { driveHandlers } from './drive_input'
import { Ground } from './ground'
import { Marks } from './marks'
import { edited } from './moving'

interface OnMapProps {
  panelId: number
  size: ReadonlySignal<CanvasSize>
  cursor: ReadonlySignal<Cursor | null>
}

export function DriveOnMap({ panelId, size, cursor }: OnMapProps) {
  const anchor = useRef<HTMLSpanElement>(null)
  useLayoutEffect(() => {
    const holder = anchor.current?.parentElement
    if (!holder) return
    return listenToMap(holder, size, cursor, driveHandlers)
  }, [panelId])
  const isHere = drivingPanel.value?.id === panelId && !inRelief.value
  const takesPresses = !inRelief.value && edited.value !== null
  return (
    <>
      <span ref={anchor} class="lesson-anchor" data-mode={takesPresses ? 'drive' : ''} hidden />
      {/* What the map's own tools draw is shown by the panel's worker until it is done. */}
      {isHere && !pressed.value && <Ground panelId={panelId} size={size} cursor={cursor} />}
      {isHere && <Marks size={size.value} />}
    </>
  )
}
