/** `t` for dialogs; importing it adds their English. */
import { addEnglish, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enDialogs } from './en/dialogs'

addEnglish(enDialogs)

export type DialogKey = TextKey | KeyOf<typeof enDialogs>

export const t = tOfPage as (key: DialogKey, args?: Record<string, unknown>) => string
