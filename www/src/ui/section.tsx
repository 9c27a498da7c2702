/** A part of the column that can be folded away; which ones are is kept on this device. */
import { signal } from '@preact/signals'
import { ChevronDown, ChevronRight } from 'lucide'
import type { ComponentChildren } from 'preact'
import { recall, remember } from '../state'
import { Icon } from './icon'

const KEY = 'formicarium.folded'
const folded = signal<ReadonlySet<string>>(new Set(recall(KEY)?.split(' ') ?? []))

interface SectionProps {
  /** Names it in what is kept, and as an element. */
  id: string
  title: string
  /** In place of the title, where the head holds tabs. */
  face?: ComponentChildren
  /** Beside the title. */
  tools?: ComponentChildren
  class?: string
  children: ComponentChildren
}

export function Section({ id, title, face, tools, children, ...props }: SectionProps) {
  const open = !folded.value.has(id)
  return (
    <section class={`column-card ${props.class ?? ''}`} id={id} aria-label={title}>
      <header class="column-head">
        {face ? (
          <Fold {...{ id, title, open }} />
        ) : (
          <h2>
            <Fold {...{ id, title, open }} words />
          </h2>
        )}
        {face}
        {open && tools}
      </header>
      {open && children}
    </section>
  )
}

function Fold(props: { id: string; title: string; open: boolean; words?: boolean }) {
  const { id, title, open, words } = props
  return (
    <button
      type="button"
      class="fold"
      aria-expanded={open}
      aria-label={words ? undefined : title}
      data-testid={`fold-${id}`}
      onClick={() => fold(id, open)}
    >
      <Icon icon={open ? ChevronDown : ChevronRight} size={14} />
      {words && title}
    </button>
  )
}

/** Folds a part away, or brings it back. */
export function fold(id: string, away: boolean): void {
  const next = new Set(folded.peek())
  if (away) next.add(id)
  else next.delete(id)
  folded.value = next
  remember(KEY, [...next].join(' '))
}
