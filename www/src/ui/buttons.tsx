import { type IconNode, X } from 'lucide'
import { Icon } from './icon'

interface IconButtonProps {
  icon: IconNode
  label: string
  onClick: (event: MouseEvent) => void
  /** As shown in the hint, e.g. "Shift+→". */
  keys?: string
  testId?: string
  disabled?: boolean
  pressed?: boolean
  /** Of a button that folds something: whether that is open. */
  expanded?: boolean
  /** The list that it opens. */
  list?: string
  tone?: 'plain' | 'quiet'
  size?: number
}

export function IconButton(props: IconButtonProps) {
  const { icon, label, keys, pressed } = props
  return (
    <button
      type="button"
      class={`icon-button ${props.tone ?? 'plain'}`}
      aria-label={label}
      aria-pressed={pressed}
      aria-expanded={props.expanded}
      aria-haspopup={props.list ? 'menu' : undefined}
      popoverTarget={props.list}
      data-tip={keys ? `${label} · ${keys}` : label}
      data-testid={props.testId}
      disabled={props.disabled}
      onClick={props.onClick}
    >
      <Icon icon={icon} size={props.size} />
    </button>
  )
}

/** In the corner of what it closes or takes away. */
export const CloseButton = (
  props: Pick<IconButtonProps, 'label' | 'keys' | 'testId' | 'onClick'>,
) => <IconButton icon={X} tone="quiet" size={16} {...props} />

interface ButtonProps {
  label: string
  onClick: (event: MouseEvent) => void
  icon?: IconNode
  tone?: 'primary' | 'plain' | 'quiet' | 'danger'
  testId?: string
  disabled?: boolean
  busy?: boolean
  /** Of a button that stays in or out. */
  pressed?: boolean
}

export function Button({ label, icon, tone = 'plain', ...props }: ButtonProps) {
  return (
    <button
      type="button"
      class={`button ${tone}`}
      data-testid={props.testId}
      disabled={props.disabled || props.busy}
      aria-busy={props.busy}
      aria-pressed={props.pressed}
      onClick={props.onClick}
    >
      {icon && <Icon icon={icon} size={16} />}
      <span>{label}</span>
    </button>
  )
}
