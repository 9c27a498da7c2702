/** Why a link or a session file cannot be opened. Has the shape of the engine's errors, and is shown like them. */
import type { EngineError } from '@pkg/formicarium'

export type LinkErrorKind =
  | 'link-foreign'
  | 'link-damaged'
  | 'link-cut'
  | 'link-changed'
  | 'link-newer'
  | 'link-too-large'
  | 'link-invalid'
  | 'link-share'
  | 'picture-bare'

const HINTS: Record<LinkErrorKind, string> = {
  'link-foreign': 'Links made by Share have #x= or #q= after the address; copy the whole link.',
  'link-damaged':
    'Part of it seems to be missing; copy the whole link again, or ask for the file instead.',
  'link-cut':
    'A program on the way left them out, as a rule at the end; copy the whole link again, or ask for the file instead.',
  'link-changed':
    'A program on the way changed some of its characters; ask for it in another way, or for the file instead.',
  'link-newer': 'Reload the page to get the newest version, then open it again.',
  'link-too-large': 'Maps of up to 4096 × 4096 cells and six panels can be opened.',
  'link-invalid': 'It was not made by Share, or was changed by hand; correct the named value.',
  'link-share':
    'Shares are written I/N, such as 3/30, or ?/30; ask who sent the link for another one.',
  'picture-bare':
    'Pictures saved here hold their session or comparison until a program that leaves such things out saves them again; ask for the original, the link or the file.',
}

export class LinkError extends Error implements EngineError {
  override readonly name = 'LinkError'
  readonly hint: string
  readonly args: Record<string, string>

  constructor(
    readonly kind: LinkErrorKind,
    message: string,
    readonly field = '',
    told: Record<string, string> = {},
  ) {
    super(message)
    this.hint = HINTS[kind]
    this.args = { field, reason: message, ...told }
  }
}

export function damaged(why: string): LinkError {
  return new LinkError('link-damaged', `The link is damaged: ${why}.`)
}

/** So many of all its characters are not here. */
export function cutShort(missing: number, all: number): LinkError {
  const message = `The link is damaged: ${missing} of its ${all} characters are missing.`
  return new LinkError('link-cut', message, '', { missing: `${missing}`, all: `${all}` })
}

export function changed(): LinkError {
  const message = 'The link is damaged: it is not the same as when it was made.'
  return new LinkError('link-changed', message)
}
