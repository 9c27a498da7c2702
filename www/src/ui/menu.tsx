/** A button that opens a list of actions beneath it. */

import { ChevronDown, type IconNode } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useId, useRef } from 'preact/hooks'
import { Icon } from './icon'

/** A longer menu than fits is scrolled; CSS pixels. */
const LEAST_HEIGHT = 300

interface MenuProps {
  label: string
  /** What the button shows; the label itself when absent. */
  face?: ComponentChildren
  testId?: string
  children: ComponentChildren
  align?: 'start' | 'end'
  bare?: boolean
  onOpen?: () => void
}

export function Menu({ label, face, testId, children, align = 'start', bare, onOpen }: MenuProps) {
  const id = useId()
  const button = useRef<HTMLButtonElement>(null)
  const list = useRef<HTMLDivElement>(null)
  const place = () => {
    if (!button.current || !list.current) return
    const { left, right, bottom } = button.current.getBoundingClientRect()
    const { style, offsetWidth } = list.current
    const wanted = align === 'start' ? left : right - offsetWidth
    // Below the button, unless that leaves too little; never beyond the screen, where nobody could scroll to.
    const top = Math.max(8, Math.min(bottom + 6, innerHeight - LEAST_HEIGHT - 8))
    style.top = `${top}px`
    style.maxHeight = `${innerHeight - top - 8}px`
    style.left = `${Math.max(8, Math.min(wanted, innerWidth - offsetWidth - 8))}px`
  }
  // The browser takes the focus there as it opens the list; `toggle` comes later than the next key may.
  const opening = () => items(list.current)[0]?.setAttribute('autofocus', '')
  const toggled = (event: Event) => {
    const open = (event as ToggleEvent).newState === 'open'
    button.current?.setAttribute('aria-expanded', String(open))
    if (!open) return
    onOpen?.()
    place()
    if (!list.current?.contains(document.activeElement)) items(list.current)[0]?.focus()
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
        onBeforeToggle={opening}
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
  /** In the place of an icon; the place is kept while there is nothing in it. */
  picture?: ComponentChildren
  note?: string
  testId?: string
  checked?: boolean
  /** Checked by itself, not as one of several. */
  toggle?: boolean
  /** Why the item cannot be chosen; shown in place of the note. */
  unavailable?: string | null
}

export function MenuItem(props: MenuItemProps) {
  const { label, onClick, icon, picture, note, testId, checked, toggle, unavailable = null } = props
  const role =
    checked === undefined
      ? { role: 'menuitem' as const }
      : { role: `menuitem${toggle ? 'checkbox' : 'radio'}` as const, 'aria-checked': checked }
  return (
    <button
      type="button"
      {...role}
      class="menu-item"
      data-testid={testId}
      aria-disabled={unavailable !== null}
      onClick={(event) => {
        if (unavailable === null) onClick()
        // The menu stays open: nothing was chosen.
        else event.stopPropagation()
      }}
    >
      {icon && <Icon icon={icon} size={16} />}
      {picture !== undefined && <span class="menu-picture">{picture}</span>}
      <span class="menu-item-text">
        <span>{label}</span>
        {(unavailable ?? note) && <span class="menu-item-note">{unavailable ?? note}</span>}
      </span>
    </button>
  )
}

interface MenuIconProps {
  label: string
  icon: IconNode
  onClick: () => void
  testId?: string
}

/** A second thing to do with the item beside it. */
export function MenuIcon({ label, icon, onClick, testId }: MenuIconProps) {
  return (
    <button
      type="button"
      role="menuitem"
      class="menu-item menu-icon"
      aria-label={label}
      title={label}
      data-testid={testId}
      onClick={onClick}
    >
      <Icon icon={icon} size={16} />
    </button>
  )
}

/** Columns stand side by side where there is room, below each other elsewhere. */
export function MenuColumn({ children }: { children: ComponentChildren }) {
  return (
    <div class="menu-column" role="presentation">
      {children}
    </div>
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
export function moveFocus(event: KeyboardEvent, list: HTMLElement | null): void {
  const all = items(list)
  const at = all.indexOf(document.activeElement as HTMLElement)
  const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key]
  if (to === undefined) return
  event.preventDefault()
  event.stopPropagation()
  all[(to + all.length) % all.length]?.focus()
}
