/** The control of one parameter: its kind and range come from the catalog. */
import type { EngineError, ParamKind, ParamSpec } from '@pkg/formicarium'
import { RotateCcw } from 'lucide'
import { useEffect, useId, useRef } from 'preact/hooks'
import { engineText, translated } from '../i18n'
import { t } from '../i18n/column'
import { errorText } from '../i18n/errors'
import type { ParamValues } from '../model/messages'
import { plannerEntry } from '../state'
import { Icon } from '../ui/icon'
import { optionName, paramMeaning, paramName, valueName } from '../words/planner_words'
import { fromSlider, SLIDER_STEPS, toSlider } from './slider_scale'

type Value = ParamValues[string]
type Ranged = Extract<ParamKind, { min: number }>

export interface ParameterRowProps {
  spec: ParamSpec
  value: Value
  /** What a reset brings back: the value of the set that was chosen. */
  base: Value
  error: EngineError | null
  onChange: (value: Value) => void
}

/** One line: symbol, name, slider, value, and the way back once it was changed. */
export function ParameterRow({ spec, value, base, error, onChange }: ParameterRowProps) {
  const id = useId()
  const changed = value !== base
  return (
    <div class="parameter" data-changed={changed} data-key={spec.key} data-kind={spec.kind.type}>
      <label class="parameter-name" for={id}>
        {spec.symbol && <Formula text={spec.symbol} />}
        <span class="name">{paramName(spec)}</span>
      </label>
      <Control spec={spec} value={value} error={error} onChange={onChange} id={id} />
      <span class="way-back">
        {changed && (
          <button
            type="button"
            class="icon-button quiet"
            aria-label={t('parameters.back', { name: paramName(spec), value: valueName(base) })}
            data-tip={t('parameters.backTip', { value: valueName(base) })}
            data-testid={`back-${spec.key}`}
            onClick={() => onChange(base)}
          >
            <Icon icon={RotateCcw} size={13} />
          </button>
        )}
      </span>
      <span class="visually-hidden" id={`${id}-meaning`}>
        {meaningOf(spec, value)}
        {spec.source && <span class="source"> · {translated(spec.source)}</span>}
      </span>
      {error && <ErrorText error={error} id={`${id}-error`} />}
    </div>
  )
}

/** A symbol as papers set it: what stands behind an underscore is an index. */
export function Formula({ text }: { text: string }) {
  const [, ...parts] = text.split(/_(\w+)/)
  return (
    <i class="symbol">
      {text.split('_')[0]}
      {parts.map((part, index) => (index % 2 === 0 ? <sub key={index}>{part}</sub> : part))}
    </i>
  )
}

/** What a parameter does, and what its chosen option does. */
export function meaningOf(spec: ParamSpec, value: Value): string {
  return `${paramMeaning(spec)}${chosenMeaning(spec, value)}`
}

/** What the option on show does; the others say so when they are chosen. */
function chosenMeaning({ key, kind }: ParamSpec, value: Value): string {
  if (kind.type !== 'choice') return ''
  const option = kind.options.find(({ id }) => id === value)
  const meaning = option && optionMeaning(key, option)
  return meaning ? t('parameters.option', { name: optionName(option.id), meaning }) : ''
}

type Option = Extract<ParamKind, { type: 'choice' }>['options'][number]

/** The name of a planner says it already. */
const optionMeaning = (key: string, { id, meaning }: Option) =>
  plannerEntry(id) ? undefined : engineText(`meanings.${key}.${id}`, meaning)

type ControlProps = Omit<ParameterRowProps, 'base'> & { id: string }

function Control({ spec, value, error, onChange, id }: ControlProps) {
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
          <option key={option.id} value={option.id} title={optionMeaning(spec.key, option)}>
            {optionName(option.id)}
          </option>
        ))}
      </select>
    )
  }
  return (
    <span class="number-pair">
      <Slider kind={kind} value={Number(value)} label={paramName(spec)} onChange={onChange} />
      <NumberInput
        {...common}
        value={Number(value)}
        fallback={Number(spec.default)}
        kind={kind}
        refused={error !== null}
        onChange={onChange}
      />
    </span>
  )
}

interface NumberInputProps {
  id: string
  kind: Ranged
  value: number
  fallback: number
  refused: boolean
  onChange: (value: number) => void
}

/** Emptied or left with Escape, the field goes back to the last value that could be used: so there is a way out of a refusal. */
function NumberInput(props: NumberInputProps) {
  const { kind, value, fallback, refused, onChange, ...common } = props
  const usable = useRef(fallback)
  if (!refused && value >= kind.min && value <= kind.max) usable.current = value
  const restore = (field: HTMLInputElement) => {
    const last = refused && usable.current === value ? fallback : usable.current
    field.value = String(last)
    if (last !== value) onChange(last)
  }
  return (
    <input
      {...common}
      class="input number"
      type="number"
      inputMode="decimal"
      step="any"
      value={value}
      aria-invalid={refused}
      onChange={({ currentTarget }) => {
        if (Number.isNaN(currentTarget.valueAsNumber)) restore(currentTarget)
        else onChange(currentTarget.valueAsNumber)
      }}
      onKeyDown={({ key, currentTarget }) => {
        if (key === 'Escape') restore(currentTarget)
      }}
    />
  )
}

interface SliderProps {
  kind: Ranged
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
  const words = errorText(error)
  const text = useRef<HTMLParagraphElement>(null)
  useEffect(() => text.current?.scrollIntoView({ block: 'nearest' }), [words])
  return (
    <p ref={text} class="field-error" id={id} role="alert">
      {words}
    </p>
  )
}
