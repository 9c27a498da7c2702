/** The field in which a panel is renamed. */
import { useLayoutEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/names'
import { LONGEST } from '../model/names'
import { panelById } from '../state'
import { setLabel } from '../state/naming'
import { panelTitle } from '../words/planner_words'

interface LabelFieldProps {
  panelId: number
  place: number
  /** `byKey`: the focus is to go back to the name. */
  onDone: (byKey: boolean) => void
}

export function LabelField({ panelId, place, onDone }: LabelFieldProps) {
  const field = useRef<HTMLInputElement>(null)
  useLayoutEffect(() => field.current?.select(), [])
  /** Leaving by a key takes the field away, which leaves it once more. */
  const left = useRef(false)
  const leave = (keep: boolean, byKey: boolean) => {
    if (left.current) return
    left.current = true
    if (keep) setLabel(panelId, field.current?.value ?? '')
    onDone(byKey)
  }
  return (
    <input
      ref={field}
      class="input label-field"
      dir="auto"
      maxLength={LONGEST.label}
      defaultValue={panelById(panelId)?.setup.label ?? ''}
      placeholder={panelTitle(panelId)}
      title={t('names.labelHint')}
      aria-label={t('names.label', { place })}
      data-testid={`label-field-${place}`}
      onKeyDown={(event) => {
        if (event.isComposing || (event.key !== 'Enter' && event.key !== 'Escape')) return
        event.preventDefault()
        leave(event.key === 'Enter', true)
      }}
      onBlur={() => leave(true, false)}
    />
  )
}
