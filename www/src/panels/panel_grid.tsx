import { useSignal } from '@preact/signals'
import { Bug } from 'lucide'
import type { ComponentType, RefObject } from 'preact'
import { useLayoutEffect, useRef } from 'preact/hooks'
import { t } from '../i18n'
import { type PanelLayout, panelLayout } from '../model/panel_layout'
import type { Size } from '../model/viewpoint'
import { comparing, focused, lessonMode, panels, scenario } from '../state'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { AddPlannerButtons } from './add_planner'
import { PanelCard, type PanelCardProps } from './panel_card'

const Difference = lazily(async () => (await import('../playback')).fetchDifference())

/** `Card` frames each panel: the page's own, or that of a page within another one. */
export function PanelGrid({ Card = PanelCard }: { Card?: ComponentType<PanelCardProps> }) {
  const place = useRef<HTMLElement>(null)
  const room = useRoom(place)
  const all = panels.value
  const alone = focused.value
  const count = alone === null ? all.length + Number(comparing.value) : 1
  const { columns, rowHeight } = layoutOf(count, room, place.current)
  if (all.length === 0) return <NoPanels />
  return (
    <section
      ref={place}
      class="panel-grid"
      style={{ '--columns': columns, '--row': rowHeight === null ? '1fr' : `${rowHeight}px` }}
      data-scrolls={rowHeight !== null}
      aria-label={t('panels.region')}
    >
      {all.map((panel, index) => (
        <Card key={panel.id} panel={panel} place={index + 1} />
      ))}
      {comparing.value && alone === null && <Difference />}
    </section>
  )
}

/** The size of the room for panels; it is known before the first frame is drawn. */
function useRoom(place: RefObject<HTMLElement | null>): Size {
  const room = useSignal<Size>({ width: 1200, height: 700 })
  const some = panels.value.length > 0
  useLayoutEffect(() => {
    const element = place.current
    if (!element) return
    const read = () => {
      room.value = { width: element.clientWidth, height: element.clientHeight }
    }
    // It reads at once, when the browser has laid out the page, and not in the middle of putting it together.
    const observer = new ResizeObserver(read)
    observer.observe(element)
    return () => observer.disconnect()
  }, [some])
  return room.value
}

/** The lengths of heads and gaps are the styles'. */
function layoutOf(count: number, room: Size, element: HTMLElement | null): PanelLayout {
  const map = scenario.value?.spec ?? { width: 3, height: 2 }
  const styles = element && getComputedStyle(element)
  const length = (name: string, otherwise: number) =>
    Number.parseFloat(styles?.getPropertyValue(name) ?? '') || otherwise
  const frame = { head: length('--panel-head', 40), border: 2, gap: length('--gap', 6) }
  return panelLayout(count, room, map, frame, lessonMode.value !== null)
}

function NoPanels() {
  return (
    <section class="empty" aria-label={t('panels.region')} data-testid="no-panels">
      <Icon icon={Bug} size={36} />
      <h2>{t('panels.none')}</h2>
      <p>{t('panels.noneHint')}</p>
      <AddPlannerButtons />
    </section>
  )
}
