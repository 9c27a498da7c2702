/** Form controls with their label; the look is the page's own, the behaviour the browser's. */
import type { ComponentChildren } from 'preact'
import { useId, useState } from 'preact/hooks'

interface Option<T extends string> {
  value: T
  label: string
}

interface SelectOption<T extends string> extends Option<T> {
  /** Options of a group stand together, under its name. */
  group?: string
  disabled?: boolean
  /** Shown by the browser beside the option. */
  note?: string
}

interface SelectProps<T extends string> {
  label: string
  value: T
  options: SelectOption<T>[]
  onChange: (value: T) => void
  testId?: string
  hideLabel?: boolean
  class?: string
  /** What the chosen option means. */
  note?: string
}

export function Select<T extends string>(props: SelectProps<T>) {
  const id = useId()
  return (
    <span class={`field ${props.class ?? ''}`}>
      <label for={id} class={props.hideLabel ? 'visually-hidden' : 'field-label'}>
        {props.label}
      </label>
      <select
        id={id}
        class="select"
        value={props.value}
        title={props.note}
        data-testid={props.testId}
        onChange={(event) => props.onChange(event.currentTarget.value as T)}
      >
        {grouped(props.options).map(([group, options]) =>
          group === '' ? (
            options.map(optionElement)
          ) : (
            <optgroup key={group} label={group}>
              {options.map(optionElement)}
            </optgroup>
          ),
        )}
      </select>
    </span>
  )
}

function optionElement<T extends string>({ value, label, disabled, note }: SelectOption<T>) {
  return (
    <option key={value} value={value} disabled={disabled} title={note}>
      {label}
    </option>
  )
}

/** By group, in the order in which the groups first appear. */
function grouped<T extends string>(options: SelectOption<T>[]): [string, SelectOption<T>[]][] {
  const groups = new Map<string, SelectOption<T>[]>()
  for (const option of options) {
    const group = option.group ?? ''
    groups.set(group, [...(groups.get(group) ?? []), option])
  }
  return [...groups]
}

interface NumberFieldProps {
  label: string
  value: number
  min: number
  max: number
  step?: number | 'any'
  onChange: (value: number) => void
  /** What is being typed; NaN where that is no number yet. */
  onType?: (value: number) => void
  /** Reports each thing that is typed, NaN where it is no number yet: for forms that check it themselves. */
  live?: boolean
  testId?: string
  hideLabel?: boolean
  invalid?: boolean
  describedBy?: string
  /** Replaces a number outside the limits by the nearest whole one inside; for values that the engine does not check. */
  nearest?: boolean
}

/** Reports what can be read as a number. The range is checked by the engine, which names the limits. */
export function NumberField(props: NumberFieldProps) {
  const id = useId()
  // What is being typed stays while the dialog is drawn anew.
  const [typed, setTyped] = useState<string | null>(null)
  return (
    <span class="field">
      <label for={id} class={props.hideLabel ? 'visually-hidden' : 'field-label'}>
        {props.label}
      </label>
      <input
        id={id}
        class="input number"
        type="number"
        inputMode="decimal"
        min={props.min}
        max={props.max}
        step={props.step ?? 'any'}
        value={typed ?? props.value}
        onInput={(event) => {
          setTyped(event.currentTarget.value)
          props.onType?.(event.currentTarget.valueAsNumber)
          if (props.live) props.onChange(event.currentTarget.valueAsNumber)
        }}
        onBlur={() => setTyped(null)}
        aria-invalid={props.invalid}
        aria-describedby={props.describedBy}
        data-testid={props.testId}
        onChange={(event) => {
          const field = event.currentTarget
          const read = field.valueAsNumber
          const value = props.nearest ? nearestWhole(read, props.min, props.max) : read
          setTyped(null)
          if (Number.isNaN(value)) field.value = String(props.value)
          else {
            if (value !== read) field.value = String(value)
            props.onChange(value)
          }
        }}
      />
    </span>
  )
}

function nearestWhole(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, Math.round(value)))
}

/** Choices under a visible label, which screen readers hear with each choice. */
export function Labelled({ label, children }: { label: string; children: ComponentChildren }) {
  return (
    <div class="labelled">
      <span class="field-label" aria-hidden="true">
        {label}
      </span>
      {children}
    </div>
  )
}

interface SegmentedProps<T extends string> {
  label: string
  value: T
  options: (Option<T> & { testId?: string; icon?: ComponentChildren })[]
  onChange: (value: T) => void
}

/** A few exclusive choices side by side. */
export function Segmented<T extends string>(props: SegmentedProps<T>) {
  return (
    <fieldset class="segmented">
      <legend class="visually-hidden">{props.label}</legend>
      {props.options.map(({ value, label, testId, icon }) => (
        <button
          key={value}
          type="button"
          class={icon ? 'segment with-icon' : 'segment'}
          aria-pressed={props.value === value}
          aria-label={icon ? label : undefined}
          data-tip={icon ? label : undefined}
          data-testid={testId}
          onClick={() => props.onChange(value)}
        >
          {icon ?? label}
        </button>
      ))}
    </fieldset>
  )
}
