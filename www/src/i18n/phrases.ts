/** Free text of the engine by its English: rows of patterns, in which `{}` stands for what differs from case to case. */

/** English and the other language; there `{}` repeats what stood in the English, in its order, and `{1}` the second of them. */
export type Phrases = Record<string, string>

/** Rewrites what a row knows; the rest stays as it is. Rows without gaps go first, then those that say most. */
export function translatorOf(phrases: Phrases): (english: string) => string {
  const patterns = Object.entries(phrases)
    .filter(([english]) => english.includes('{}'))
    .sort(([a], [b]) => saidBy(b) - saidBy(a))
    .map(([english, other]) => ({ pattern: patternOf(english), other }))
  return (english) => {
    const known = phrases[english]
    if (known !== undefined) return known
    for (const { pattern, other } of patterns) {
      const found = pattern.exec(english)
      if (found) return filled(other, found.slice(1))
    }
    return english
  }
}

/** Letters beside the gaps. */
const saidBy = (english: string) => english.replaceAll('{}', '').length

function patternOf(english: string): RegExp {
  const parts = english.split('{}').map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'))
  return new RegExp(`^${parts.join('(.+?)')}$`, 's')
}

function filled(text: string, gaps: string[]): string {
  let next = 0
  return text.replace(/\{(\d?)\}/g, (_, place) => gaps[place === '' ? next++ : Number(place)] ?? '')
}
