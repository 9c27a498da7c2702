/** The page as it is served, with an ear put before all else that hears its errors: for browsers whose drivers do not tell them. */
import { once } from 'node:events'
import { createServer, type ServerResponse } from 'node:http'
import { portOf } from './programs'

declare global {
  interface Window {
    complaints: string[]
  }
}

export interface Ear {
  /** Where the page is that is listened to. */
  address: string
  close(): void
}

export async function hearing(site: string): Promise<Ear> {
  const server = createServer(({ url = '/' }, response) => {
    pass(new URL(url, site), response).catch((error) => response.writeHead(502).end(String(error)))
  })
  server.listen(0, 'localhost')
  await once(server, 'listening')
  const close = () => {
    server.close()
    server.closeAllConnections()
  }
  return { address: `http://localhost:${portOf(server)}/`, close }
}

async function pass(url: URL, response: ServerResponse): Promise<void> {
  const answer = await fetch(url)
  const type = answer.headers.get('content-type') ?? ''
  response.writeHead(answer.status, { 'content-type': type })
  if (type.startsWith('text/html'))
    response.end((await answer.text()).replace('<head>', `<head><script>(${listen})()</script>`))
  else response.end(Buffer.from(await answer.arrayBuffer()))
}

/** On the page: whatever a console would show as an error. */
function listen(): void {
  window.complaints = []
  const hear = (...words: unknown[]) => window.complaints.push(words.map(String).join(' '))
  const write = console.error
  console.error = (...words) => {
    hear(...words)
    write(...words)
  }
  // Those of scripts, and of files that cannot be had.
  addEventListener('error', ({ message, target }) => hear(message ?? target), true)
  addEventListener('unhandledrejection', ({ reason }) => hear(reason))
  addEventListener('securitypolicyviolation', (event) =>
    hear(event.violatedDirective, event.blockedURI),
  )
}
