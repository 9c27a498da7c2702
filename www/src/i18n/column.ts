/** `t` for what stands beside the maps, in the column or in its place; importing it adds their English. */
import { addEnglish, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enColumn } from './en/column'

addEnglish(enColumn)

export type ColumnKey = TextKey | KeyOf<typeof enColumn>

export const t = tOfPage as (key: ColumnKey, args?: Record<string, unknown>) => string
