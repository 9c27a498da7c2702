/** `t` for dialogs; importing it adds their English. */
import { addEnglish, type KeyOf } from '.'
import { type ColumnKey, t as tOfPage } from './column'
import { enDialogs } from './en/dialogs'

addEnglish(enDialogs)

export type DialogKey = ColumnKey | KeyOf<typeof enDialogs>

export const t = tOfPage as (key: DialogKey, args?: Record<string, unknown>) => string
