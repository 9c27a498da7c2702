import { errorText } from '../i18n/errors'

/** What a dialog could not do, where the reader looks. */
export function FormError({ error }: { error: unknown }) {
  return (
    <p class="field-error" role="alert">
      {errorText(error)}
    </p>
  )
}
