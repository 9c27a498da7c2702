/** `t` for the further tools, whose words are fetched with them. */
import { addWords, type KeyOf, type TextKey, t as tOfPage } from '.'
import { enEditor } from './en/editor'

const english = { editor: enEditor }

export type EditorKey = TextKey | KeyOf<typeof english>

export const t = tOfPage as (key: EditorKey, args?: Record<string, unknown>) => string

/** Before anything of them is shown. */
export const addEditorWords = () => addWords(english, fetchChinese)

async function fetchChinese(): Promise<object> {
  return { editor: (await import('./zh_cn/editor')).zhCNEditor }
}
