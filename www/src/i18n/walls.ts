/** `t` for walls that change while planners run, whose words are fetched with that part. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enWalls } from './en/walls'

const english = { walls: enWalls }

export type WallsKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: WallsKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addWallsWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { walls: (await import('./zh_cn/walls')).zhCNWalls }
}
