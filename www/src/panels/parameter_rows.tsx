/** Rows of parameters, and beside the one under the pointer or with the focus what it means and where it comes from. */
import type { ParamSpec } from '@pkg/formicarium'
import { useSignal } from '@preact/signals'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { translated } from '../i18n'
import { t } from '../i18n/column'
import { paramName, valueName } from '../words/planner_words'
import { unitWords } from './parameter_groups'
import { Formula, meaningOf, ParameterRow, type ParameterRowProps } from './parameter_row'

/** A pointer on its way elsewhere does not call up notes. */
const PAUSE_MS = 300
/** CSS pixels between a row and its note. */
const SPACE = 10

interface Noted {
  key: string
  row: HTMLElement
}

export function ParameterRows({ rows }: { rows: ParameterRowProps[] }) {
  const noted = useSignal<Noted | null>(null)
  const timer = useRef(0)
  useEffect(() => () => clearTimeout(timer.current), [])
  const later = (next: Noted | null) => {
    clearTimeout(timer.current)
    timer.current = window.setTimeout(() => {
      noted.value = next
    }, PAUSE_MS)
  }
  const atOnce = (next: Noted | null) => {
    clearTimeout(timer.current)
    noted.value = next
  }
  const now = noted.value && rows.find(({ spec }) => spec.key === noted.value?.key)
  return (
    <div
      class="parameter-rows"
      onPointerOver={(event) => event.pointerType === 'mouse' && later(rowOf(event))}
      onPointerLeave={() => later(null)}
      onFocusIn={(event) => atOnce(rowOf(event))}
      onFocusOut={() => atOnce(null)}
    >
      {rows.map((row) => (
        <ParameterRow key={row.spec.key} {...row} />
      ))}
      {now && noted.value && <Note {...now} row={noted.value.row} />}
    </div>
  )
}

function rowOf({ target }: Event): Noted | null {
  const row = target instanceof Element ? target.closest<HTMLElement>('.parameter') : null
  const key = row?.dataset.key
  return row && key !== undefined ? { key, row } : null
}

/** It lies above everything and takes no room. Screen readers have its words with the control. */
function Note({ spec, value, base, row }: ParameterRowProps & { row: HTMLElement }) {
  const note = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    if (!note.current) return
    note.current.showPopover()
    placeBeside(note.current, row)
  }, [row, spec])
  return (
    <div ref={note} class="parameter-note" popover="manual" aria-hidden="true">
      <p class="note-name">
        {spec.symbol && <Formula text={spec.symbol} />} {paramName(spec)}
      </p>
      <p>{meaningOf(spec, value)}</p>
      <dl>
        <Fact name={t('parameters.range')} value={rangeOf(spec)} />
        <Fact name={t('parameters.base')} value={valueName(base)} />
        <Fact name={t('parameters.source')} value={translated(spec.source)} />
      </dl>
    </div>
  )
}

function Fact({ name, value }: { name: string; value: string }) {
  if (value === '') return null
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  )
}

function rangeOf({ kind, unit }: ParamSpec): string {
  if (kind.type !== 'integer' && kind.type !== 'real') return ''
  return `${kind.min} … ${kind.max} ${unitWords(unit)}`.trim()
}

/** To the left of the row; above or below it, where there is no room. */
function placeBeside(note: HTMLElement, row: HTMLElement): void {
  const { left, top, bottom } = row.getBoundingClientRect()
  const { offsetWidth, offsetHeight } = note
  const beside = left - offsetWidth - SPACE
  const above = top - offsetHeight - SPACE
  const y = beside >= SPACE ? top : above >= SPACE ? above : bottom + SPACE
  note.style.left = `${Math.max(SPACE, beside >= SPACE ? beside : left)}px`
  note.style.top = `${Math.max(SPACE, Math.min(y, innerHeight - offsetHeight - SPACE))}px`
}
