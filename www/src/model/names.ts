/** Names and notes that readers write: how long they may be, and in which form they are kept. */

/** Most characters, as JavaScript counts them. */
export const LONGEST = { label: 60, title: 120, note: 2000, map: 200 } as const

/** Control characters and the line separators of Unicode: none of them belongs in one line. */
const UNPRINTABLE = /[\p{Cc}\u2028\u2029]/u
/** A note has tabs and line breaks. */
const UNPRINTABLE_IN_NOTES = /[^\P{Cc}\t\n]|[\u2028\u2029]/u

export const isOneLine = (text: string) => !UNPRINTABLE.test(text)
export const isNote = (text: string) => !UNPRINTABLE_IN_NOTES.test(text)

/** What was typed or pasted into a field of one line, as it is kept. */
export function oneLine(typed: string, most: number): string {
  const line = typed.replace(new RegExp(UNPRINTABLE, 'gu'), ' ').trim()
  return line.slice(0, most).trim()
}

/** Line breaks of all systems are one kind. */
export const lineBreaks = (text: string) => text.replace(/\r\n?|[\u2028\u2029]/g, '\n')

/** What was typed or pasted as a note, as it is kept: without blank lines around it. */
export function noteText(typed: string): string {
  const text = lineBreaks(typed).replace(new RegExp(UNPRINTABLE_IN_NOTES, 'gu'), ' ').trim()
  return text.slice(0, LONGEST.note).trim()
}
