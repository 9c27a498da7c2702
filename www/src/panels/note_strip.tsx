/** What the race is called and what is said of it, in one line that can be hidden. The whole note opens beneath it. */
import { effect, signal } from '@preact/signals'
import { PenLine } from 'lucide'
import { useEffect, useId, useRef } from 'preact/hooks'
import { t } from '../i18n/names'
import type { Caption } from '../model/session'
import { announce, caption, view } from '../state'
import { openDialog, show } from '../state/dialogs'
import { CloseButton, IconButton } from '../ui/buttons'
import { mapName } from '../words/map_names'

/** The last one that the reader has hidden. */
const hidden = signal<Caption | null>(null)

/** The tab is called as the race, while that is on show. */
export function showInTab(): void {
  let before = ''
  effect(() => {
    const title = view.value === 'race' ? caption.value.title : ''
    if (title !== '' || before !== '')
      document.title = title === '' ? t('app.title') : t('names.tab', { title })
    before = title
  })
}

export function NoteStrip() {
  const now = caption.value
  const title = now.title || mapName()
  useEffect(() => {
    // Whoever writes it knows it.
    if ((now.title || now.note) && openDialog.peek() === null)
      announce(now.note ? t('names.opened', { title, note: now.note }) : title)
  }, [now])
  if (hidden.value === now || !(now.title || now.note)) return null
  return (
    <aside class="note-strip" aria-label={t('names.region')} data-testid="note-strip">
      <strong dir="auto">{title}</strong>
      {now.note && <Note text={now.note} />}
      <span class="spacer" />
      <IconButton
        icon={PenLine}
        label={t('names.edit')}
        tone="quiet"
        size={16}
        testId="note-edit"
        onClick={() => show('names')}
      />
      <CloseButton
        label={t('names.close')}
        testId="note-close"
        onClick={() => {
          hidden.value = now
        }}
      />
    </aside>
  )
}

/** CSS pixels. */
const EDGE = 8

/** Its first line, and a button that shows all of it. */
function Note({ text }: { text: string }) {
  const id = useId()
  const button = useRef<HTMLButtonElement>(null)
  const whole = useRef<HTMLDivElement>(null)
  const place = () => {
    if (!button.current || !whole.current) return
    const { left, bottom } = button.current.getBoundingClientRect()
    const { style, offsetWidth } = whole.current
    style.top = `${bottom + EDGE}px`
    style.left = `${Math.max(EDGE, Math.min(left, innerWidth - offsetWidth - EDGE))}px`
    style.maxHeight = `${innerHeight - bottom - 2 * EDGE}px`
  }
  /** The page's own Escape would keep the note open. */
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && whole.current?.matches(':popover-open')) event.stopPropagation()
  }
  return (
    <>
      <button
        ref={button}
        type="button"
        class="note-start"
        popoverTarget={id}
        title={t('names.read')}
        data-testid="note-read"
        onKeyDown={onKeyDown}
      >
        <span dir="auto">{text.split('\n', 1)[0]}</span>
      </button>
      <div
        ref={whole}
        id={id}
        popover="auto"
        class="note-text"
        role="note"
        aria-label={t('names.note')}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a long note is scrolled by keys
        tabIndex={0}
        dir="auto"
        data-testid="note-text"
        onKeyDown={onKeyDown}
        onToggle={(event) => {
          if (event.newState === 'open') place()
        }}
      >
        {text}
      </div>
    </>
  )
}
