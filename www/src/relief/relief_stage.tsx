/** One panel's terrain in three dimensions, in place of its flat map. */
import { useComputed, useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import '../styles/relief.css'
import { t } from '../i18n'
import { CellReadout } from '../stage/cell_readout'
import { watchSize } from '../stage/element_size'
import { Inspector, inspector, isInspected } from '../stage/inspected'
import type { CanvasSize, Cursor } from '../stage/panel_view'
import { scenario, tool } from '../state'
import { leaveRelief } from '../state/relief'
import { reliefKeyHandler } from './relief_keys'
import { ReliefPointer } from './relief_pointer'
import { ReliefView } from './relief_view'

export { resetEye, zoomEye } from './eye'

export function ReliefStage({ panelId }: { panelId: number }) {
  const host = useRef<HTMLDivElement>(null)
  const size = useSignal<CanvasSize>({ width: 1, height: 1, dpr: 1 })
  const cursor = useSignal<Cursor | null>(null)
  const label = useComputed(() => {
    const spec = scenario.value?.spec
    return spec
      ? t('relief.label', { name: spec.name, width: spec.width, height: spec.height })
      : ''
  })

  useEffect(() => {
    const element = host.current
    if (element === null) return
    const stopMeasuring = watchSize(element, (measured) => {
      size.value = measured
    })
    let view: ReliefView
    try {
      view = new ReliefView(panelId, element, size, cursor)
    } catch {
      stopMeasuring()
      leaveRelief('missing')
      return
    }
    const inspect = inspector(panelId)
    const pointer = new ReliefPointer(element, view, size, cursor, inspect)
    const onKey = reliefKeyHandler(cursor, inspect)
    element.addEventListener('keydown', onKey)
    return () => {
      element.removeEventListener('keydown', onKey)
      pointer.release()
      view.dispose()
      stopMeasuring()
    }
  }, [panelId])

  return (
    <>
      <div
        ref={host}
        class="stage relief"
        data-testid={`stage-${panelId}`}
        data-tool={tool.value}
        role="application"
        aria-label={label}
        aria-describedby="relief-help"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: an application region is operated with the keyboard
        tabIndex={0}
      />
      <CellReadout cursor={cursor} />
      {isInspected(panelId) && <Inspector panelId={panelId} size={null} />}
    </>
  )
}
