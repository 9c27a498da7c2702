/**
 * A few exclusive choices side by side, of which none may be chosen: radio buttons, with their keys. Whoever shows them brings
 * styles/radio_segments.css.
 */
import { useId } from 'preact/hooks'

interface RadioSegmentsProps<T extends string> {
  /** What is chosen, for screen readers. */
  label: string
  value: T | null
  options: { value: T; label: string }[]
  testId: string
  /** Id of what says more about the choice. */
  describedBy?: string
  onChange: (value: T) => void
}

export function RadioSegments<T extends string>(props: RadioSegmentsProps<T>) {
  const { label, value, options, testId, describedBy, onChange } = props
  const group = useId()
  return (
    <div
      class="segmented radio-segments"
      role="radiogroup"
      aria-label={label}
      aria-describedby={describedBy}
      data-testid={testId}
    >
      {options.map((option) => (
        <label key={option.value} class="segment">
          <input
            type="radio"
            name={group}
            checked={option.value === value}
            data-testid={`${testId}-${option.value}`}
            onChange={() => onChange(option.value)}
          />
          <span>{option.label}</span>
        </label>
      ))}
    </div>
  )
}
