/** Parts one after another, with the signs of the reader's language between them. */
import { language } from '.'

const isChinese = () => language.value === 'zh-CN'

/** a, b, c */
export const listed = (parts: string[]) => parts.join(isChinese() ? '、' : ', ')

/** a; b; c: of parts that may hold lists themselves. */
export const inTurn = (parts: string[]) => parts.join(isChinese() ? '；' : '; ')

/** One. Another. The last ends as it ends. */
export const inSentences = (parts: string[]) => parts.join(isChinese() ? '。' : '. ')

/** what: value */
export const saying = (what: string, value: string) => `${what}${isChinese() ? '：' : ': '}${value}`
