/** `t` for dialogs: whoever imports it brings their English along. */
import { addEnglish, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enDialogs } from './en/dialogs'

addEnglish(enDialogs)

export type DialogKey = TextKey | KeyOf<typeof enDialogs>

export const t = tOfPage as (key: DialogKey, args?: Record<string, unknown>) => string
