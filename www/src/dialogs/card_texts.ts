/** The text of a card: the same files as in docs, each fetched when somebody reads it. docs/zh has every one in Chinese. */
import type { Language } from '../i18n'
import { METHODOLOGY } from '../words/paper_cards'

const texts = import.meta.glob<string>(
  [
    '../../../docs/papers/*.md',
    '../../../docs/methodology.md',
    '../../../docs/zh/papers/*.md',
    '../../../docs/zh/methodology.md',
  ],
  { query: '?raw', import: 'default' },
)

const FOLDERS: Record<Language, string> = { en: '', 'zh-CN': 'zh/' }

export async function cardText(card: string, language: Language): Promise<string> {
  const file = card === METHODOLOGY ? card : `papers/${card}`
  const fetched = texts[`../../../docs/${FOLDERS[language]}${file}.md`]
  if (!fetched) throw new Error(`there is no card ${card}`)
  return fetched()
}
