/** The link that runs the race again, and its code; both as films, steps and pictures carry them. */
import { type QrCode, qrCode } from '../figures/qr_code'
import { LINK_LIMIT } from '../share/envelope'
import { encodeSession, PREFIX } from '../share/link'
import { LinkError } from '../share/link_error'
import { pageAddress } from '../share/page_file'
import { currentSession } from '../state'

export interface RaceLink {
  /** Null where the race is too large for a link. */
  link: string | null
  /** Null where the link is too long for a code. */
  code: QrCode | null
}

export async function linkOfRace(): Promise<RaceLink> {
  const link = await made()
  // A page that came from no host has no address that a camera could open.
  const isAddress = link !== null && !link.startsWith(PREFIX)
  return { link, code: isAddress ? await qrCode(link) : null }
}

async function made(): Promise<string | null> {
  const session = currentSession()
  if (!session) return null
  try {
    const text = await encodeSession(session)
    const link = `${pageAddress()}${PREFIX}${text}`
    return link.length > LINK_LIMIT ? null : link
  } catch (error) {
    if (error instanceof LinkError) return null
    throw error
  }
}
