/** A button that opens a list of actions beneath it. */

import { ChevronDown, type IconNode } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useId, useRef } from 'preact/hooks'
import { Icon } from './icon'

interface MenuProps {
  label: string
  /** What the button shows; the label itself when absent. */
  face?: ComponentChildren
  testId?: string
  children: ComponentChildren
  align?: 'start' | 'end'
  bare?: boolean
}

export function Menu({ label, face, testId, children, align = 'start', bare }: MenuProps) {
  const id = useId()
  const button = useRef<HTMLButtonElement>(null)
  const list = useRef<HTMLDivElement>(null)
  const place = () => {
    if (!button.current || !list.current) return
    const { left, right, bottom } = button.current.getBoundingClientRect()
    const { style, offsetWidth } = list.current
    const wanted = align === 'start' ? left : right - offsetWidth
    style.top = `${bottom + 6}px`
    style.left = `${Math.max(8, Math.min(wanted, innerWidth - offsetWidth - 8))}px`
  }
  const toggled = (event: Event) => {
    const open = (event as ToggleEvent).newState === 'open'
    button.current?.setAttribute('aria-expanded', String(open))
    if (!open) return
    place()
    items(list.current)[0]?.focus()
  }
  return (
    <>
      <button
        ref={button}
        type="button"
        class={bare ? 'icon-button plain' : 'button menu-button'}
        popoverTarget={id}
        aria-haspopup="menu"
        aria-expanded="false"
        aria-label={label}
        data-testid={testId}
      >
        {face ?? <span>{label}</span>}
        {!bare && <Icon icon={ChevronDown} size={14} />}
      </button>
      <div
        ref={list}
        id={id}
        popover="auto"
        role="menu"
        aria-label={label}
        class="menu"
        tabIndex={-1}
        onToggle={toggled}
        onKeyDown={(event) => moveFocus(event, list.current)}
        onClick={() => list.current?.hidePopover()}
      >
        {children}
      </div>
    </>
  )
}

interface MenuItemProps {
  label: string
  onClick: () => void
  icon?: IconNode
  note?: string
  testId?: string
  checked?: boolean
}

export function MenuItem({ label, onClick, icon, note, testId, checked }: MenuItemProps) {
  const role =
    checked === undefined
      ? { role: 'menuitem' as const }
      : { role: 'menuitemradio' as const, 'aria-checked': checked }
  return (
    <button type="button" {...role} class="menu-item" data-testid={testId} onClick={onClick}>
      {icon && <Icon icon={icon} size={16} />}
      <span class="menu-item-text">
        <span>{label}</span>
        {note && <span class="menu-item-note">{note}</span>}
      </span>
    </button>
  )
}

export function MenuHeading({ text }: { text: string }) {
  return (
    <div class="menu-heading" role="presentation">
      {text}
    </div>
  )
}

function items(list: HTMLElement | null): HTMLElement[] {
  return [...(list?.querySelectorAll<HTMLElement>('.menu-item') ?? [])]
}

/** Arrows and Home/End walk through the items, as in every menu. */
function moveFocus(event: KeyboardEvent, list: HTMLElement | null): void {
  const all = items(list)
  const at = all.indexOf(document.activeElement as HTMLElement)
  const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key]
  if (to === undefined) return
  event.preventDefault()
  event.stopPropagation()
  all[(to + all.length) % all.length]?.focus()
}
