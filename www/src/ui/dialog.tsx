import { TriangleAlert, X } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useEffect, useId, useLayoutEffect, useRef } from 'preact/hooks'
import '../styles/dialogs.css'
import { t } from '../i18n/column'
import { dialogNotice, dismissInDialog } from '../state/dialog_notice'
import { IconButton } from './buttons'
import { holdPresses } from './held_press'
import { Icon } from './icon'

holdPresses()

interface DialogProps {
  title: string
  onClose: () => void
  children: ComponentChildren
  actions?: ComponentChildren
  wide?: boolean
  testId?: string
  /** Whether there is nothing in it that takes the focus, so that keys could not scroll it. */
  prose?: boolean
  /** What Enter does while no control has the focus. */
  onEnter?: () => void
  /** Whether its fields report what is typed at once, so that Enter counts in them as well. */
  live?: boolean
}

/** A modal dialog: the browser keeps the focus inside, closes on Esc and gives the focus back. */
export function Dialog(props: DialogProps) {
  const { title, onClose, children, actions, wide, testId, prose, onEnter, live } = props
  const dialog = useRef<HTMLDialogElement>(null)
  const titleId = useId()
  // At once: a key that is pressed as it appears is the dialog's.
  useLayoutEffect(() => {
    dialog.current?.showModal()
    // The dialog itself gets the focus: the hint of its first button would cover its text.
    dialog.current?.focus()
  }, [])
  return (
    <dialog
      ref={dialog}
      class={wide ? 'dialog wide' : 'dialog'}
      aria-labelledby={titleId}
      data-testid={testId}
      tabIndex={-1}
      onClose={onClose}
      onClick={(event) => {
        if (event.target === dialog.current) onClose()
      }}
      onKeyDown={(event) => {
        const typing = live && event.target instanceof HTMLInputElement
        if (event.key === 'Enter' && (typing || event.target === dialog.current)) onEnter?.()
      }}
    >
      <div class="dialog-body">
        <header class="dialog-head">
          <h2 id={titleId}>{title}</h2>
          <IconButton icon={X} label={t('common.close')} tone="quiet" onClick={onClose} />
        </header>
        <div class="dialog-content" tabIndex={prose ? 0 : undefined}>
          {children}
        </div>
        {actions && <footer class="dialog-actions">{actions}</footer>}
      </div>
      <Notice />
    </dialog>
  )
}

/** Where the page has its messages, which lie beneath the dialog. */
function Notice() {
  useEffect(() => dismissInDialog, [])
  const message = dialogNotice.value
  return (
    <div class="toasts" aria-live="polite">
      {message && (
        <div class="toast warning" data-testid="dialog-notice">
          <Icon icon={TriangleAlert} />
          <p class="toast-text">{message}</p>
          <IconButton
            icon={X}
            label={t('notices.dismiss')}
            tone="quiet"
            onClick={dismissInDialog}
          />
        </div>
      )}
    </div>
  )
}
