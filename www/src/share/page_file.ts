/**
 * Pages of one file (`formicarium/page@1`, docs/formats.md): a template with what it carries written into it. The command line writes
 * the same (`src/cli/page.rs`).
 */
import { oneFile } from '../model/one_file'

/** What a template is about: between these, what differs from page to page. */
const TITLE = ['<title>', '</title>'] as const
const CARRIED = ['<script type="application/json" id="carried"', '</script>'] as const
const FORMAT = 'data-format="formicarium/page@1"'

/** Megabytes of a page that carries little; `one_file.spec.ts` holds it. */
export const ABOUT_MB = 2.5

/** Where links lead: to this page or, from a page of one file, to the one that it was saved from; empty where that is unknown. */
export const pageAddress = (): string => oneFile()?.from ?? location.href.replace(/#.*$/, '')

/** The text of a page of one file: this page's own, or the one that lies beside it. Throws where it cannot be had. */
export async function pageTemplate(): Promise<string> {
  const own = oneFile()
  if (own) return own.html
  const response = await fetch('./one-file.html')
  if (!response.ok) throw new Error(`HTTP ${response.status}`)
  const text = await response.text()
  // A host may answer any address with its own page.
  if (!text.includes(FORMAT)) throw new Error('one-file.html')
  return text
}

/** What a page of one file carries, as a text that can be opened; null where a text is no such page, or carries nothing. */
export function carriedIn(page: string): string | null {
  const at = page.indexOf(CARRIED[0])
  if (at < 0) return null
  const text = page.slice(page.indexOf('>', at) + 1, page.indexOf(CARRIED[1], at))
  return text === '' ? null : textOf(text)
}

/** A link is written as a text of JSON. */
export const textOf = (carried: string): string =>
  carried.startsWith('"') ? JSON.parse(carried) : carried

/** A page with its title and the text that it carries: a session's or comparison's file. */
export function pageWith(template: string, title: string, carried: string): string {
  const from = /^https?:/.test(pageAddress()) ? pageAddress() : ''
  const opening = `${CARRIED[0]} ${FORMAT} data-from="${escaped(from)}">`
  const named = replaced(template, TITLE, `${TITLE[0]}${escaped(titleOfPage(title))}`)
  // In JSON this sign stands in texts alone, and none of them may end the element.
  return replaced(named, CARRIED, opening + carried.trim().replaceAll('<', '\\u003c'))
}

export const titleOfPage = (title: string) =>
  title === '' ? 'Formicarium' : `${title} · Formicarium`

/** Up to the end of what stood there. */
function replaced(page: string, [begin, end]: readonly [string, string], by: string): string {
  const at = page.indexOf(begin)
  return page.slice(0, at) + by + page.slice(page.indexOf(end, at))
}

/** As browsers write texts and attributes out. */
const escaped = (text: string) =>
  text
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;')
    .replaceAll('\u00a0', '&nbsp;')
