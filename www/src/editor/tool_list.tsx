/** A list beside a tool's button: pressed while its tool is in hand, the button opens it. */
import type { ComponentChildren } from 'preact'
import { useEffect, useRef } from 'preact/hooks'
import { moveFocus } from '../ui/menu'

interface ToolListProps {
  /** The `popovertarget` of the button. */
  id: string
  label: string
  /** Opens at once: the button was pressed before there was a list. */
  open?: boolean
  children: ComponentChildren
}

export function ToolList({ id, label, open = false, children }: ToolListProps) {
  const list = useRef<HTMLDivElement>(null)
  useEffect(() => {
    if (open) list.current?.showPopover()
  }, [])
  return (
    <div
      ref={list}
      id={id}
      popover="auto"
      role="menu"
      aria-label={label}
      class="menu tool-list"
      tabIndex={-1}
      onToggle={(event) => toggled(event, list.current)}
      onKeyDown={(event) => moveFocus(event, list.current)}
      onClick={() => list.current?.hidePopover()}
    >
      {children}
    </div>
  )
}

/** What opens beside its button: the button tells, and it is put in its place. False as it closes. */
export function placeBeside(event: Event, list: HTMLElement | null): boolean {
  const open = (event as ToggleEvent).newState === 'open'
  const button = document.querySelector(`[popovertarget="${list?.id}"]`)
  button?.setAttribute('aria-expanded', String(open))
  if (!open || !list || !button) return false
  place(list, button.getBoundingClientRect())
  return true
}

function toggled(event: Event, list: HTMLElement | null): void {
  if (!placeBeside(event, list) || !list) return
  const chosen = list.querySelector<HTMLElement>('[aria-checked="true"]')
  const first = chosen ?? list.querySelector<HTMLElement>('.menu-item')
  if (!list.contains(document.activeElement)) first?.focus()
}

/** Below the button, or above it where there is more room; never beyond the screen. */
function place(list: HTMLElement, { left, top, bottom }: DOMRect): void {
  const { style, offsetWidth } = list
  const below = innerHeight - bottom > top
  style.left = `${Math.max(8, Math.min(left, innerWidth - offsetWidth - 8))}px`
  style.top = below ? `${bottom + 6}px` : 'auto'
  style.bottom = below ? 'auto' : `${innerHeight - top + 6}px`
  style.maxHeight = `${(below ? innerHeight - bottom : top) - 14}px`
}
