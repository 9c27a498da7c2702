/** What is wrong with a quantity, at its field. */
import type { Quantity, WrongQuantity } from './quantities'

/** Properties of the field of a quantity; `id` tells the group to which it belongs. */
export function checkedBy(field: Quantity, wrong: WrongQuantity | null, id: string) {
  const invalid = wrong?.field === field
  return { invalid, describedBy: invalid ? `${id}-wrong` : undefined }
}

interface WrongProps {
  wrong: WrongQuantity | null
  /** The quantities of the group. */
  of: readonly (Quantity | null)[]
  id: string
  testId: string
}

export function Wrong({ wrong, of, id, testId }: WrongProps) {
  if (!wrong || !of.includes(wrong.field)) return null
  return (
    <p class="field-error" role="alert" id={`${id}-wrong`} data-testid={testId}>
      {wrong.why()}
    </p>
  )
}
