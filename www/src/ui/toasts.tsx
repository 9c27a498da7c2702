import { CircleCheck, CircleX, Info, TriangleAlert, X } from 'lucide'
import { t } from '../i18n'
import { announcement, dismiss, goOn, hold, type Toast, toasts } from '../state'
import { Button, IconButton } from './buttons'
import { Icon } from './icon'

const ICONS = { info: Info, success: CircleCheck, warning: TriangleAlert, error: CircleX }

export function Toasts() {
  return (
    <>
      <output class="visually-hidden" aria-live="polite" data-testid="announcement">
        {announcement}
      </output>
      <section class="toasts" aria-label={t('notices.region')} aria-live="polite">
        {toasts.value.map((toast) => (
          <ToastCard key={toast.id} toast={toast} />
        ))}
      </section>
    </>
  )
}

function ToastCard({ toast }: { toast: Toast }) {
  const { id, tone, message, hint, action } = toast
  return (
    <div
      class={`toast ${tone}`}
      data-testid={`toast-${tone}`}
      onPointerEnter={() => hold(id)}
      onPointerLeave={() => goOn(id)}
      onFocusIn={() => hold(id)}
      onFocusOut={() => goOn(id)}
    >
      <Icon icon={ICONS[tone]} />
      <div class="toast-text">
        <p>{message}</p>
        {hint && <p class="toast-hint">{hint}</p>}
        {action && <Button label={action.label} tone="quiet" onClick={action.run} />}
      </div>
      <IconButton icon={X} label={t('notices.dismiss')} tone="quiet" onClick={() => dismiss(id)} />
    </div>
  )
}
