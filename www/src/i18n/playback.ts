/** `t` for looking back at runs and into cells, whose words are fetched with it. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enPlayback } from './en/playback'

const english = { playback: enPlayback }

export type PlaybackKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: PlaybackKey, args?: Record<string, unknown>) => string

/** Before anything of it is shown. */
export const addPlaybackWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { playback: (await import('./zh_cn/playback')).zhCNPlayback }
}
