/** `t` for smooth curves and what driving costs, whose words are fetched with what shows them. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enDriving } from './en/driving'

const english = { driving: enDriving }

export type DrivingKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: DrivingKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addDrivingWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { driving: (await import('./zh_cn/driving')).zhCNDriving }
}
