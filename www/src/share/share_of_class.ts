/**
 * Whose share of a comparison's runs a link asks for, in the link behind its text: `&share=3/30`, or `&share=?/30` where whoever opens it
 * is asked.
 */
import { LinkError } from './link_error'

const KEY = '&share='
const WRITTEN = /^(\?|[1-9]\d{0,8})\/([1-9]\d{0,8})$/

export interface ShareOfClass {
  /** From 1 on; null until somebody chooses. */
  index: number | null
  /** How many there are. */
  of: number
}

/** As it is written: `3/30`, `?/30`. */
export const shareText = ({ index, of }: ShareOfClass) => `${index ?? '?'}/${of}`

/** What a link for a share ends with. */
export const shareEnding = (share: ShareOfClass) => KEY + shareText(share)

/** Throws a LinkError for what names no share. */
export function readShare(text: string): ShareOfClass {
  const [, index = '', of = ''] = WRITTEN.exec(text) ?? []
  const share = { index: index === '?' ? null : Number(index), of: Number(of) }
  if (of === '' || (share.index ?? 1) > share.of) throw noShare(text)
  return share
}

export const noShare = (text: string) =>
  new LinkError('link-share', `There is no share “${short(text)}”`, short(text))

const short = (text: string) => text.slice(0, 40)

/** A link's text, and the share behind it. Throws a LinkError for anything else behind it. */
export function splitShare(fragment: string): { text: string; share: ShareOfClass | null } {
  const [text = '', ...ending] = fragment.split('&')
  if (ending.length === 0) return { text, share: null }
  const said = decoded(`&${ending.join('&')}`)
  if (!said.startsWith(KEY)) throw noShare(said)
  return { text, share: readShare(said.slice(KEY.length)) }
}

/** Some programs write `?` and `/` as their codes. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}
