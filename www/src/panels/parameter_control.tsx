/** The control of one parameter: its kind and range come from the catalog. */
import type { EngineError, ParamKind, ParamSpec } from '@pkg/formicarium'
import { useEffect, useId, useRef } from 'preact/hooks'
import { t } from '../i18n'
import { describeError } from '../i18n/errors'
import type { ParamValues } from '../messages'
import { optionName, paramMeaning } from './planner_text'
import { fromSlider, SLIDER_STEPS, toSlider } from './slider_scale'

type Value = ParamValues[string]

interface ParameterControlProps {
  spec: ParamSpec
  value: Value
  error: EngineError | null
  onChange: (value: Value) => void
}

export function ParameterControl({ spec, value, error, onChange }: ParameterControlProps) {
  const id = useId()
  const changed = value !== spec.default
  return (
    <div class="parameter" data-changed={changed}>
      <label class="parameter-name" for={id}>
        {spec.symbol && <i class="symbol">{spec.symbol}</i>}
        <span>{spec.key.replaceAll('_', ' ')}</span>
        {spec.unit && spec.unit !== spec.key && <span class="unit">{spec.unit}</span>}
      </label>
      <Control spec={spec} value={value} error={error} onChange={onChange} id={id} />
      <p class="parameter-meaning" id={`${id}-meaning`}>
        {paramMeaning(spec)}
        {chosenMeaning(spec, value)}
        {spec.source && <span class="source"> · {spec.source}</span>}
        {changed && (
          <button type="button" class="link" onClick={() => onChange(spec.default)}>
            {t('parameters.back', { value: String(spec.default) })}
          </button>
        )}
      </p>
      {error && <ErrorText error={error} id={`${id}-error`} />}
    </div>
  )
}

/** What the option on show does; the others say so when they are chosen. */
function chosenMeaning({ kind }: ParamSpec, value: Value): string {
  if (kind.type !== 'choice') return ''
  const option = kind.options.find(({ id }) => id === value)
  return option ? `. ${optionName(option.id)}: ${option.meaning}` : ''
}

function Control({ spec, value, error, onChange, id }: ParameterControlProps & { id: string }) {
  const describedBy = error ? `${id}-meaning ${id}-error` : `${id}-meaning`
  const common = { id, 'aria-describedby': describedBy, 'data-testid': `param-${spec.key}` }
  const { kind } = spec
  if (kind.type === 'flag') {
    return (
      <input
        {...common}
        type="checkbox"
        class="switch"
        role="switch"
        checked={value === true}
        aria-checked={value === true}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
    )
  }
  if (kind.type === 'choice') {
    return (
      <select
        {...common}
        class="select"
        value={String(value)}
        onChange={(event) => onChange(event.currentTarget.value)}
      >
        {kind.options.map((option) => (
          <option key={option.id} value={option.id} title={option.meaning}>
            {optionName(option.id)}
          </option>
        ))}
      </select>
    )
  }
  return (
    <span class="number-pair">
      <Slider kind={kind} value={Number(value)} label={spec.key} onChange={onChange} />
      <input
        {...common}
        class="input number"
        type="number"
        inputMode="decimal"
        step="any"
        value={Number(value)}
        aria-invalid={error !== null}
        onChange={(event) => {
          const { valueAsNumber } = event.currentTarget
          if (!Number.isNaN(valueAsNumber)) onChange(valueAsNumber)
        }}
      />
    </span>
  )
}

interface SliderProps {
  kind: Extract<ParamKind, { min: number }>
  value: number
  label: string
  onChange: (value: number) => void
}

function Slider({ kind, value, label, onChange }: SliderProps) {
  return (
    <input
      class="slider"
      type="range"
      min={0}
      max={SLIDER_STEPS}
      step={1}
      value={toSlider(value, kind)}
      aria-label={t('parameters.slider', { name: label })}
      aria-valuetext={String(value)}
      onInput={(event) => onChange(fromSlider(event.currentTarget.valueAsNumber, kind))}
    />
  )
}

function ErrorText({ error, id }: { error: EngineError; id: string }) {
  const { message, hint } = describeError(error)
  const text = useRef<HTMLParagraphElement>(null)
  useEffect(() => text.current?.scrollIntoView({ block: 'nearest' }), [message])
  return (
    <p ref={text} class="field-error" id={id} role="alert">
      {message} {hint}
    </p>
  )
}
