/** One panel's map: mounts the worker's canvas, tells it what to show, and turns pointer and keys into edits. */
import { useComputed, useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import { attach } from '../engine/panel_clients'
import { t } from '../i18n'
import { editor, lesson, lessonMode, scenario, stopsMet, tool, wholeEngine } from '../state'
import { lazyParts } from '../state/lazy_parts'
import { inRelief, relief } from '../state/relief'
import { lazily } from '../ui/lazily'
import { mapName } from '../words/map_names'
import { CellReadout } from './cell_readout'
import { watchSize } from './element_size'
import { Inspector, inspector, isInspected } from './inspected'
import { keyboardHandler } from './keyboard'
import { sendOnceAFrame } from './once_a_frame'
import { type CanvasSize, type Cursor, lookAt } from './panel_view'
import { pointedCell } from './pointed_places'
import { PointerInput } from './pointer'

const LessonOnMap = lazily(() => lazyParts.lesson('map'))

export function Stage({ panelId }: { panelId: number }) {
  const Relief = inRelief.value ? relief.value?.ReliefStage : null
  return (
    <>
      {Relief ? <Relief panelId={panelId} /> : <FlatStage panelId={panelId} />}
      {wholeEngine.value === 'here' && <LayerLegend panelId={panelId} />}
    </>
  )
}

// Fetched once the whole engine is here: ants should not have to wait for it.
const LayerLegend = lazily(async () => (await import('./layer_legend')).fetchLegend())

function FlatStage({ panelId }: { panelId: number }) {
  const host = useRef<HTMLDivElement>(null)
  const EditPreview = editor.value?.EditPreview
  const size = useSignal<CanvasSize>({ width: 1, height: 1, dpr: 1 })
  const cursor = useSignal<Cursor | null>(null)
  const label = useComputed(() => {
    const spec = scenario.value?.spec
    return spec ? t('stage.label', { name: mapName(), width: spec.width, height: spec.height }) : ''
  })

  useEffect(() => {
    const element = host.current
    if (element === null) return
    const client = attach(panelId, element)
    const stopMeasuring = watchSize(element, (measured) => {
      size.value = measured
    })
    const stopLooking = sendOnceAFrame(
      () => lookAt(panelId, size.value, cursor.value ?? pointedCell(panelId)),
      (view) => client.setView(view),
    )
    const inspect = inspector(panelId)
    const pointer = new PointerInput(element, size, cursor, inspect)
    const onKey = keyboardHandler(size, cursor, inspect)
    element.addEventListener('keydown', onKey)
    return () => {
      element.removeEventListener('keydown', onKey)
      pointer.release()
      stopLooking()
      stopMeasuring()
    }
  }, [panelId])

  return (
    <>
      <div
        ref={host}
        class="stage"
        data-testid={`stage-${panelId}`}
        data-tool={tool.value}
        role="application"
        aria-label={label}
        aria-describedby="stage-help"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: an application region is operated with the keyboard
        tabIndex={0}
      />
      {EditPreview && <EditPreview size={size} cursor={cursor} />}
      <CellReadout cursor={cursor} />
      {isInspected(panelId) && <Inspector panelId={panelId} size={size} />}
      {(lessonMode.value ?? lesson.value?.drawn ?? stopsMet.value[0]) && (
        <LessonOnMap panelId={panelId} size={size} cursor={cursor} />
      )}
    </>
  )
}
