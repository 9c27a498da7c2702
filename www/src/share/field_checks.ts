/** Checks of values that come from outside, each naming the field it refuses. */
import { LinkError } from './link_error'

export type Fields = Record<string, unknown>

export function fieldsOf(value: unknown, field: string): Fields {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Fields
  throw invalid(field, 'must be an object')
}

export function list(value: unknown, field: string, most: number): unknown[] {
  if (!Array.isArray(value)) throw invalid(field, 'must be a list')
  if (value.length > most)
    throw new LinkError(
      'link-too-large',
      `${field} has ${value.length} entries; at most ${most} are allowed.`,
      field,
    )
  return value
}

export function integer(value: unknown, field: string, min: number, max: number): number {
  const checked = real(value, field, min, max)
  if (Number.isInteger(checked)) return checked
  throw invalid(field, 'must be a whole number')
}

export function real(value: unknown, field: string, min: number, max: number): number {
  if (typeof value === 'number' && value >= min && value <= max) return value
  throw invalid(field, `must be a number from ${min} to ${max}`)
}

export function text(value: unknown, field: string, most: number): string {
  if (typeof value === 'string' && value.length <= most) return value
  throw invalid(field, `must be a text of at most ${most} characters`)
}

export function oneOf<T extends string | number>(
  value: unknown,
  field: string,
  allowed: readonly T[],
): T {
  const found = allowed.find((each) => each === value)
  if (found !== undefined) return found
  throw invalid(field, `must be one of ${allowed.join(', ')}`)
}

export function cell(
  value: unknown,
  field: string,
  width: number,
  height: number,
): [number, number] {
  const [x, y] = list(value, field, 2)
  return [integer(x, `${field}[0]`, 0, width - 1), integer(y, `${field}[1]`, 0, height - 1)]
}

export function invalid(field: string, what: string): LinkError {
  return new LinkError('link-invalid', `${field} ${what}.`, field)
}
