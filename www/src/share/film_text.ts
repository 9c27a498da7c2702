/** The link in a film of ours: it stands in the comment, near the beginning of a WebM file or the end of an MP4 one. */

/** Metadata lies within so many bytes of either end. */
const REACH = 1 << 18
/** Addresses are shorter; without a bound, a file of nothing but beginnings would take minutes. */
const LINK = /https?:\/\/[^\s"'<>#]{0,1000}#x=[\w-]+/

const EBML = [0x1a, 0x45, 0xdf, 0xa3]
const FTYP = [...'ftyp'].map((letter) => letter.charCodeAt(0))

const startsWith = (bytes: Uint8Array, start: number[], at = 0) =>
  start.every((byte, i) => bytes[at + i] === byte)

export const isFilm = (bytes: Uint8Array): boolean =>
  startsWith(bytes, EBML) || startsWith(bytes, FTYP, 4)

/** Null where there is none. */
export function linkOfFilm(bytes: Uint8Array): string | null {
  const decoder = new TextDecoder('latin1')
  for (const part of [bytes.subarray(0, REACH), bytes.subarray(-REACH)]) {
    const found = LINK.exec(decoder.decode(part))
    if (found) return found[0]
  }
  return null
}
