/**
 * The page's own files, fetched with words for what can go wrong: the connection, or a newer version of the page that has taken the
 * files of this one away.
 */
import { outdated, unreachable } from '../model/errors'

/** Throws an EngineError. */
export async function fetchOwn(url: string): Promise<Response> {
  const response = await fetch(url).catch(refuse)
  if (response.ok && !isPage(response)) return response
  // Some hosts answer with the page itself where a file is not there.
  if (response.ok || response.status === 404 || response.status === 410) throw outdated()
  throw unreachable(`HTTP ${response.status}`)
}

const isPage = (response: Response) =>
  response.headers.get('content-type')?.startsWith('text/html') ?? false

/** For what a browser says of a connection that has failed: nothing that would help. */
export function refuse(): never {
  throw unreachable()
}
