/** CSV as the page writes it; the engine's own files come from `src/comparison/report/csv.rs`, by the same rules. */

/** Spreadsheets take a text that begins like this for a formula. */
const FORMULA = /^[=+\-@\t\r]/
/** What a number looks like; it stays one, whatever it begins with. */
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$|^[+-]?(inf|infinity|nan)$/i

type Cell = string | number | undefined

/** Lines of equal columns below their names; a cell that is not there is empty. */
export function csvOf(header: readonly string[], lines: Iterable<readonly Cell[]>): string {
  return [header, ...lines].map((cells) => `${cells.map(written).join(',')}\n`).join('')
}

function written(cell: Cell): string {
  const text = harmless(String(cell ?? ''))
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** A quote before it makes a formula a text. */
const harmless = (text: string) => (FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text)
