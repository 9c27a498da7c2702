/**
 * The link that stands in a text or an address, whatever writers and programs have made of it: signs as codes (`%23`, `&amp;`, `=3D`), broken
 * lines, marks of quotation, signs that nobody sees, and what stands behind it.
 */
import { damaged, LinkError } from './link_error'

/** Codes may have been made codes again: `%2523`. */
const HEAD = /(?:#|%(?:25)*23|&#35;|=23)([xq])(?:=3D|=|%(?:25)*3[Dd]|&#61;)/
/** Of the gallery. */
const LESSON = /#lesson=[\w-]+/

/** Zero width, soft hyphens, and marks of direction. */
const UNSEEN = /[\u00ad\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]|&(?:shy|#8203);|<wbr *\/?>/g

/** Between words or lines, with what quotes the next line. */
const BREAK = /\s[\s>|]{0,20}/
const TEXT = new RegExp(`^(?:${BREAK.source})?[\\w-]+(?:(?:${BREAK.source})[\\w-]+)*`)
/** So many words behind a link are looked at. */
const MOST_WORDS = 200

/** What follows addresses and is none of them. */
const TRAILING = /[\s.,;:!?)\]}>"'’”»…*_~|`。，、；：！？）】》」』]/
/** What programs put behind addresses: to know where readers came from, or to look at where they go. */
const TRACKER =
  /^(?:utm_\w+|fbclid|gclid|msclkid|igshid|mc_[ce]id|_hsenc|_hsmi|si|ref|s?data|reserved)=/

const MOST_TIMES_CODED = 3

/**
 * From `#x=`, `#q=` or `#lesson=` on; null where there is none. The text may be in several words: which of them belong to it, it knows itself
 * (envelope.ts). A file may contain a link, so only text that is no JSON is searched for one.
 */
export function linkIn(text: string): string | null {
  const head = text.trimStart().startsWith('{') ? null : HEAD.exec(text)
  if (!head) return LESSON.exec(text)?.[0] ?? null
  const behind = plain(text.slice(head.index + head[0].length))
  const [written = ''] = TEXT.exec(behind) ?? []
  if (written === '') return null
  const words = written.trim().split(BREAK).slice(0, MOST_WORDS)
  const ending = head[1] === 'q' ? endingOf(behind.slice(written.length)) : ''
  return `#${head[1]}=${words.join(' ')}${ending}`
}

/** What stands behind `#x=` or `#q=` in the link of a text. Throws a LinkError where there is nothing, or another link. */
export function textBehind(prefix: string, text: string, what: string): string {
  const link = linkIn(text)
  if (link?.startsWith(prefix)) return link.slice(prefix.length)
  if (text.includes(prefix)) throw damaged('it contains characters no link has')
  throw new LinkError('link-foreign', `This link holds no ${what}.`)
}

/** Signs for their codes, lines for those that mail has broken. */
function plain(text: string): string {
  let now = text
    .replace(/=\r?\n/g, '')
    .replace(/^[^&]+/, (before) => before.replace(/=(20|2D|5F|0D|0A|09)/g, '%$1'))
  for (let turn = 0; turn < MOST_TIMES_CODED && now.includes('%'); turn++)
    now = now.replace(/(?:%[\dA-Fa-f]{2})+/g, decoded)
  return now.replaceAll('&amp;', '&').replace(UNSEEN, '')
}

function decoded(codes: string): string {
  try {
    return decodeURIComponent(codes)
  } catch {
    return codes
  }
}

/** What a comparison's link has behind its text, from `&` on. */
function endingOf(behind: string): string {
  const [first = '', ...pieces] = (/^[&?]\S*/.exec(behind)?.[0] ?? '').split(/(?=&|\?utm)/)
  if (first === '&') return first
  const told = [first, ...pieces].filter(
    (piece) => !TRACKER.test(piece.slice(1)) && piece.startsWith('&'),
  )
  return told.map((piece) => withoutTrailing(piece).replace('=3D', '=')).join('')
}

/** From its end on: an expression that may begin anywhere takes minutes for a long row of dots. */
function withoutTrailing(piece: string): string {
  let end = piece.endsWith('=20') ? piece.length - 3 : piece.length
  while (end > 0 && TRAILING.test(piece.charAt(end - 1))) end--
  return piece.slice(0, end)
}
