/** `t` for a robot that drives, whose words are fetched with that part. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enDrive } from './en/drive'

const english = { drive: enDrive }

export type DriveKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: DriveKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addDriveWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { drive: (await import('./zh_cn/drive')).zhCNDrive }
}
