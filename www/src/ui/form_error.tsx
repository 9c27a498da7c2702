import { describeError } from '../i18n/errors'

/** What a dialog could not do, where the reader looks. */
export function FormError({ error }: { error: unknown }) {
  const { message, hint } = describeError(error)
  return (
    <p class="field-error" role="alert">
      {message} {hint}
    </p>
  )
}
