/** Shows the engine's refusal of a comparison at the field that it names. */
import type { EngineError } from '@pkg/formicarium'
import type { DraftEntry } from '../../model/draft'
import { isEngineError } from '../../model/errors'
import { entries, refusal } from './draft'
import { idsOf } from './labels'

/** The refusal, if it is about this field or one below it. */
export function refusalOf(field: string): EngineError | null {
  const error = refusal.value
  if (!isEngineError(error)) return null
  return error.field === field || error.field.startsWith(`${field}.`) ? error : null
}

/** The refusal of an entry. If it is about a parameter, its field is the parameter's key alone. */
export function refusalOfEntry(entry: DraftEntry): EngineError | null {
  const all = entries.value
  const id = idsOf(all)[all.indexOf(entry)]
  const error = refusalOf(`entries.${id}`)
  return error && { ...error, field: error.field.replace(`entries.${id}.`, '') }
}

export function isShownElsewhere(error: unknown): boolean {
  if (!isEngineError(error)) return false
  return ['entries', 'seeds', 'budget'].some((field) => error.field.startsWith(`${field}.`))
}
