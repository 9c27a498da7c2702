/** A card beside the map, clear of the cell that it is about; Esc closes it and gives the focus back to the map. */
import { X } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useLayoutEffect } from 'preact/hooks'
import { t } from '../i18n/lesson'
import type { Cell } from '../model/cell'
import type { CanvasSize } from '../stage/panel_view'
import { openDialog } from '../state/dialogs'
import { IconButton } from '../ui/buttons'
import { pointOn } from './map_lines'

interface CardProps {
  title: string
  /** What it keeps clear of. */
  cell: Cell
  size: CanvasSize
  panelId: number
  testId: string
  onClose: () => void
  /** Keys of the card, wherever the focus is; true when the key was used. */
  onKey?: (event: KeyboardEvent) => boolean
  children: ComponentChildren
}

export function Card({ title, cell, size, panelId, testId, onClose, onKey, children }: CardProps) {
  const close = () => {
    onClose()
    document.querySelector<HTMLElement>(`[data-testid="stage-${panelId}"]`)?.focus()
  }
  useLayoutEffect(() => {
    const listener = (event: KeyboardEvent) => {
      if (event.defaultPrevented || openDialog.peek() || isElsewhere(event)) return
      if (event.key === 'Escape') close()
      else if (!onKey?.(event)) return
      event.preventDefault()
      event.stopPropagation()
    }
    addEventListener('keydown', listener, { capture: true })
    return () => removeEventListener('keydown', listener, { capture: true })
  }, [panelId])
  const [x, y] = pointOn(size, cell)
  return (
    <section
      class="moves-card lesson-card"
      data-side={x > size.width / size.dpr / 2 ? 'left' : 'right'}
      data-end={y > size.height / size.dpr / 2 ? 'top' : 'bottom'}
      aria-label={title}
      data-testid={testId}
    >
      <header>
        <h3>{title}</h3>
        <IconButton
          icon={X}
          label={t('lesson.close')}
          keys="Esc"
          tone="quiet"
          size={16}
          testId={`${testId}-close`}
          onClick={close}
        />
      </header>
      {children}
    </section>
  )
}

/** Menus and open boxes have the keys first; what is typed into a field is the field's, but for Esc. */
function isElsewhere({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false
  if (target.closest('[role="menu"], [popover]')) return true
  return key !== 'Escape' && target.matches('input, select, textarea')
}
