/**
 * A card clear of the maps, about one panel's map, which it brings into sight. It can be folded to one line; Esc closes it and gives
 * the focus back to the map. Its height does not depend on what it says: nothing moves while it changes.
 */
import { signal } from '@preact/signals'
import { ChevronDown, ChevronUp } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useEffect, useLayoutEffect } from 'preact/hooks'
import { t } from '../i18n/lesson'
import { compact, lessonMode, openColumn, panelColour } from '../state'
import { openDialog } from '../state/dialogs'
import { CloseButton, IconButton } from '../ui/buttons'

interface CardProps {
  title: string
  /** What is said while it is folded. */
  line: string
  panelId: number
  testId: string
  onClose: () => void
  /** Keys of the card, wherever the focus is; true when the key was used. */
  onKey?: (event: KeyboardEvent) => boolean
  children: ComponentChildren
}

/** Whoever wants only the map wants it for the next card as well. */
const folded = signal(false)

export function Card({ title, line, panelId, testId, onClose, onKey, children }: CardProps) {
  const close = () => {
    onClose()
    stageOf(panelId)?.focus()
  }
  useLayoutEffect(() => {
    const listener = (event: KeyboardEvent) => {
      if (event.defaultPrevented || openDialog.peek() || isElsewhere(event)) return
      if (!onKey?.(event)) {
        if (event.key !== 'Escape') return
        close()
      }
      event.preventDefault()
      event.stopPropagation()
    }
    addEventListener('keydown', listener, { capture: true })
    return () => removeEventListener('keydown', listener, { capture: true })
  }, [panelId])
  useEffect(() => keepInSight(panelId), [panelId])
  return (
    <CardFrame
      colour={panelColour(panelId)}
      title={title}
      line={line}
      testId={testId}
      closeKeys="Esc"
      onClose={close}
    >
      {children}
    </CardFrame>
  )
}

interface FrameProps extends Pick<CardProps, 'title' | 'line' | 'testId' | 'onClose' | 'children'> {
  /** Of the panel that it is about, if it is about one. */
  colour?: string
  closeKeys?: string
}

/** The card as it is drawn: its head, by which it is folded and closed, and its body. */
export function CardFrame(props: FrameProps) {
  const { colour, title, line, testId } = props
  const isFolded = folded.value
  useEffect(() => {
    // The sheet lies over it.
    if (compact.peek()) openColumn(false)
  }, [])
  return (
    <section
      class="lesson-card"
      style={{ '--panel-colour': colour }}
      data-mode={lessonMode.value ?? 'guide'}
      data-folded={isFolded}
      aria-label={title}
      data-testid={testId}
    >
      <header>
        <h3>
          {colour && <span class="panel-dot" aria-hidden="true" />}
          <span>{title}</span>
        </h3>
        <p class="card-line">{isFolded && line}</p>
        <IconButton
          icon={isFolded ? ChevronUp : ChevronDown}
          label={t(isFolded ? 'lesson.unfold' : 'lesson.fold')}
          tone="quiet"
          size={16}
          expanded={!isFolded}
          testId="card-fold"
          onClick={() => {
            folded.value = !isFolded
          }}
        />
        <CloseButton
          label={t('lesson.close')}
          keys={props.closeKeys}
          testId={`${testId}-close`}
          onClick={props.onClose}
        />
      </header>
      {!isFolded && <div class="card-body">{props.children}</div>}
    </section>
  )
}

const stageOf = (panelId: number) =>
  document.querySelector<HTMLElement>(`[data-testid="stage-${panelId}"]`)

/** Where panels are scrolled, the one that it is about comes into sight, and again when the room for panels has changed. */
function keepInSight(panelId: number): (() => void) | undefined {
  const panel = stageOf(panelId)?.closest('.panel')
  if (!panel) return
  const observer = new ResizeObserver(() => panel.scrollIntoView({ block: 'nearest' }))
  observer.observe(panel)
  return () => observer.disconnect()
}

/** Menus and open boxes have the keys first; what is typed into a field is the field's, but for Esc. */
function isElsewhere({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false
  if (target.closest('[role="menu"], [popover]')) return true
  return key !== 'Escape' && target.matches('input, select, textarea')
}
