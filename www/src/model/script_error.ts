/** Why a script's call was refused: an Error with the fields of the engine's errors. */
import type { EngineError } from '@pkg/formicarium'
import { isEngineError } from './errors'

export class ScriptError extends Error implements EngineError {
  override readonly name = 'FormicariumError'

  constructor(
    readonly kind: string,
    readonly field: string,
    message: string,
    readonly hint: string,
    readonly args: Record<string, string> = {},
  ) {
    super(message)
  }
}

/** What was thrown, with the fields that a script may rely on. */
export function toScriptError(thrown: unknown): ScriptError {
  if (thrown instanceof ScriptError) return thrown
  if (isEngineError(thrown)) {
    const { kind, field, message, hint, args } = thrown
    return new ScriptError(kind, field ?? '', message, hint, args)
  }
  const message = thrown instanceof Error ? thrown.message : String(thrown)
  return new ScriptError('unexpected', '', message, 'Try it again; the page is as it was before.')
}

/** The call with its errors made such ones. */
export async function typed<T>(call: () => Promise<T>): Promise<T> {
  try {
    return await call()
  } catch (error) {
    throw toScriptError(error)
  }
}

/** The value is not what the option takes. */
export function badOption(field: string, what: string): ScriptError {
  return new ScriptError('bad-option', field, `${field} ${what}`, 'See docs/scripting.md.')
}

/** Of an object with options, or of none, each must be among the known ones. */
export function optionsOf<K extends string>(
  given: unknown,
  known: readonly K[],
  field: string,
): Partial<Record<K, unknown>> {
  if (given === undefined) return {}
  if (typeof given !== 'object' || given === null || Array.isArray(given))
    throw badOption(field, 'must be an object with options')
  for (const key of Object.keys(given)) {
    if ((known as readonly string[]).includes(key)) continue
    const hint = `The options are ${known.join(', ')}.`
    throw new ScriptError('unknown-option', key, `${field} has no option "${key}"`, hint)
  }
  return given
}

export function wholeNumber(value: unknown, field: string, least: number, most: number): number {
  if (Number.isInteger(value) && Number(value) >= least && Number(value) <= most)
    return Number(value)
  throw badOption(field, `must be a whole number from ${least} to ${most}`)
}

export function shortText(value: unknown, field: string, most: number): string {
  if (typeof value === 'string' && value.trim() !== '' && value.length <= most) return value
  throw badOption(field, `must be a text of 1 to ${most} characters`)
}

export function trueOrFalse(value: unknown, field: string): boolean {
  if (typeof value === 'boolean') return value
  throw badOption(field, 'must be true or false')
}
