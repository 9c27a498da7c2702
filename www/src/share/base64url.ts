/** Bytes as the letters that an address may have, without padding. */
import { damaged } from './link_error'

/** Many arguments at once overflow the stack, so the bytes go in blocks. */
export function toBase64url(bytes: Uint8Array): string {
  let binary = ''
  for (let at = 0; at < bytes.length; at += 8192)
    binary += String.fromCharCode(...bytes.subarray(at, at + 8192))
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
}

export function fromBase64url(text: string): Uint8Array<ArrayBuffer> {
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
