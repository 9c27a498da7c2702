/** `t` for what ground costs and for the robot, whose words are fetched with what shows them. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enWeights } from './en/weights'

const english = { weights: enWeights }

export type WeightsKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: WeightsKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addWeightWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { weights: (await import('./zh_cn/weights')).zhCNWeights }
}
