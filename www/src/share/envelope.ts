/** Container bytes ⇄ fragment text: base64url of one byte (0 stored, 1 deflated) and the bytes, whichever is shorter. */
import { MAX_BYTES } from './codec'
import { deflate, inflate } from './deflate'
import { damaged, LinkError } from './link_error'

/** Longer links are cut by some hosts and mail programs: offer a file instead. Characters of the fragment's payload. */
export const LINK_LIMIT = 8000

const STORED = 0
const DEFLATED = 1

export async function seal(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const deflated = await deflate(bytes)
  const [method, payload] = deflated.length < bytes.length ? [DEFLATED, deflated] : [STORED, bytes]
  const sealed = new Uint8Array(payload.length + 1)
  sealed[0] = method
  sealed.set(payload, 1)
  return toBase64url(sealed)
}

export async function open(text: string): Promise<Uint8Array> {
  if (text.length > 2 * MAX_BYTES)
    throw new LinkError('link-too-large', 'The link is longer than any map needs.')
  const sealed = fromBase64url(text)
  const payload = sealed.subarray(1)
  switch (sealed[0]) {
    case STORED:
      return payload
    case DEFLATED:
      return inflate(payload, MAX_BYTES).catch((error: unknown) => {
        throw error instanceof LinkError ? error : damaged('it cannot be unpacked')
      })
    default:
      throw damaged('its first byte names no way of packing')
  }
}

/** Many arguments at once overflow the stack, so the bytes go in blocks. */
function toBase64url(bytes: Uint8Array): string {
  let binary = ''
  for (let at = 0; at < bytes.length; at += 8192)
    binary += String.fromCharCode(...bytes.subarray(at, at + 8192))
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
}

function fromBase64url(text: string): Uint8Array<ArrayBuffer> {
  if (text === '' || /[^A-Za-z0-9_-]/.test(text))
    throw damaged('it contains characters no link has')
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (char) =>
      char.charCodeAt(0),
    )
  } catch {
    throw damaged('its length is impossible')
  }
}
