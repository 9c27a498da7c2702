/** Text in the reader's language. `t` reads a signal, so components that call it follow a change of language. */
import { computed, effect, signal } from '@preact/signals'
import i18next from 'i18next'
import { enEngine } from './en/engine'
import { en } from './en/page'

export const LANGUAGES = { en: 'English', 'zh-CN': '简体中文' } as const
export type Language = keyof typeof LANGUAGES

type Leaves<T> = {
  [K in keyof T & string]: T[K] extends string ? K : `${K}.${Leaves<T[K]>}`
}[keyof T & string]
type WithoutPlural<K extends string> = K extends `${infer Base}_one` | `${infer Base}_other`
  ? Base
  : K
/** The keys of an English dictionary; the other languages are checked against it by their type. */
export type KeyOf<Dictionary> = WithoutPlural<Leaves<Dictionary>>
/** The keys that are there from the beginning. */
export type TextKey = KeyOf<typeof en>

i18next.init({
  lng: 'en',
  fallbackLng: 'en',
  initAsync: false,
  interpolation: { escapeValue: false },
  resources: { en: { translation: en, engine: enEngine } },
})

export const language = signal<Language>('en')

/** Adds the English of a part of the page. */
export function addEnglish(words: object): void {
  i18next.addResourceBundle('en', 'translation', words, true)
}

type More = () => Promise<object>
const chineseToCome = new Set<More>()

/**
 * Adds the text of a part that is fetched on demand: English at once, Chinese when it is the language. What could not be fetched is tried
 * again with each call, so a part asks whenever it is wanted.
 */
export async function addWords(english: object, chinese: More): Promise<void> {
  addEnglish(english)
  chineseToCome.add(chinese)
  if (language.peek() === 'zh-CN') await addChinese()
}

/** Words that come meanwhile are added, too. */
async function addChinese(): Promise<void> {
  for (const fetch of chineseToCome) {
    i18next.addResourceBundle('zh-CN', 'translation', await fetch(), true)
    chineseToCome.delete(fetch)
  }
}

let inChinese = (english: string) => english

/** Only English comes with the page; other dictionaries are fetched when they are first wanted. */
export async function useLanguage(choice: Language): Promise<void> {
  if (choice === 'zh-CN' && !i18next.hasResourceBundle(choice, 'translation')) {
    const [{ zhCN }, { zhCNDialogs }, { zhCNEngine }, { zhCNSources }, phrases] = await Promise.all(
      [
        import('./zh_cn/page'),
        import('./zh_cn/dialogs'),
        import('./zh_cn/engine'),
        import('./zh_cn/sources'),
        import('./zh_cn/phrases'),
      ],
    )
    inChinese = phrases.inChinese
    i18next.addResourceBundle(choice, 'translation', zhCN)
    i18next.addResourceBundle(choice, 'translation', { ...zhCNDialogs, texts: zhCNSources }, true)
    // The engine speaks English; what a dictionary has for its names and errors replaces that.
    i18next.addResourceBundle(choice, 'engine', zhCNEngine)
  }
  if (choice === 'zh-CN') await addChinese()
  language.value = choice
}

/**
 * The reader's language, before anything is shown: the one chosen on an earlier visit, else the browser's. Without its dictionary the
 * page speaks English.
 */
export async function startLanguage(chosen: string | null): Promise<void> {
  await useLanguage(preferred(chosen)).catch(() => {})
}

export function t(key: TextKey, args?: Record<string, unknown>): string {
  const lng = language.value
  // Most texts stand as they are in the dictionary, and opening the page asks for hundreds.
  const text: unknown = args ?? i18next.getResource(lng, 'translation', key)
  return typeof text === 'string' ? text : i18next.t(key, { lng, ...args })
}

/** Text of the engine, translated if the dictionary has it. */
export function engineText(key: string, english: string, args?: Record<string, unknown>): string {
  return i18next.t(key, { lng: language.value, ns: 'engine', defaultValue: english, ...args })
}

/** Translates text that has no key, such as sources in the catalog and questions of papers, by its English. What no dictionary has stays as it is. */
export function translated(english: string): string {
  const texts: Record<string, string> =
    i18next.getResourceBundle(language.value, 'translation').texts ?? {}
  return Object.hasOwn(texts, english) ? (texts[english] ?? english) : english
}

/** What the engine says in words of its own, where they are known. */
export const phrase = (english: string) =>
  language.value === 'zh-CN' ? inChinese(english) : english

export const numbers = computed(() => ({
  whole: new Intl.NumberFormat(language.value, { maximumFractionDigits: 0 }),
  length: new Intl.NumberFormat(language.value, {
    minimumFractionDigits: 2,
    maximumFractionDigits: 2,
  }),
  /** Of a goal. */
  weight: new Intl.NumberFormat(language.value, {
    minimumFractionDigits: 3,
    maximumFractionDigits: 3,
  }),
  /** Heights and sizes in metres, as precise as is worth reading. */
  metres: new Intl.NumberFormat(language.value, { maximumFractionDigits: 2 }),
  /** The factor by which heights are exaggerated or, below 1, flattened. */
  times: new Intl.NumberFormat(language.value, { maximumSignificantDigits: 2 }),
  share: new Intl.NumberFormat(language.value, { style: 'percent', maximumSignificantDigits: 2 }),
  percent: new Intl.NumberFormat(language.value, {
    style: 'percent',
    minimumFractionDigits: 1,
    maximumFractionDigits: 1,
    signDisplay: 'exceptZero',
  }),
}))

function preferred(chosen: string | null): Language {
  if (chosen === 'en' || chosen === 'zh-CN') return chosen
  return /^zh([-_]|$)/i.test(navigator.language) ? 'zh-CN' : 'en'
}

effect(() => {
  document.documentElement.lang = language.value
  document.title = t('app.title')
})
