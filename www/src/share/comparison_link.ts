/**
 * A comparison as a link: question, maps and what was recorded, without the runs.
 *
 *     u32 checksum · u8 container version · varint n · n bytes of JSON (`formicarium/comparison@1`)
 *
 * The same checksum and packing as a session's link (share/codec.ts, share/envelope.ts).
 */
import { Reader, varint } from './byte_stream'
import { MAX_BYTES, verifiedBytes, withChecksum } from './codec'
import { open, seal } from './envelope'
import { damaged, LinkError } from './link_error'

export const PREFIX = '#q='

const VERSION = 1

/** The text after `#q=`. */
export async function encodeDocument(document: string): Promise<string> {
  const json = new TextEncoder().encode(document)
  if (json.length > MAX_BYTES)
    throw new LinkError('link-too-large', `A link carries no document of ${json.length} bytes.`)
  return seal(withChecksum([[VERSION, ...varint(json.length)], json]))
}

/** The document of an address that carries one. Throws a LinkError. */
export async function decodeFragment(hash: string): Promise<string> {
  const at = hash.indexOf(PREFIX)
  if (at < 0) throw new LinkError('link-foreign', 'This link carries no comparison.')
  const reader = new Reader(verifiedBytes(await open(hash.slice(at + PREFIX.length))))
  const version = reader.byte()
  if (version > VERSION)
    throw new LinkError(
      'link-newer',
      `The link's container has version ${version}; this page reads ${VERSION}.`,
    )
  if (version < VERSION) throw damaged('its first byte is no container version')
  const json = reader.take(reader.varint())
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(json)
  } catch {
    throw damaged('its description cannot be read')
  }
}
