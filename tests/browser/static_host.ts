/** A static host of the built page for one test: it can be stopped, and can put up a newer version of the page. */
import { once } from 'node:events'
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createServer, type Server, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { extname, join } from 'node:path'

const TYPES: Record<string, string> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
}

/** Files whose names change with their content. */
const FOR_A_YEAR = 'public, max-age=31536000, immutable'

/** Where the page has been built. */
export const DIST = join(__dirname, '../../www/dist')

export class StaticHost {
  /** Paths that were asked for. */
  readonly asked: string[] = []
  private isBroken = false

  private constructor(
    readonly folder: string,
    /** Where the page is. */
    readonly address: string,
    private readonly base: string,
    private readonly server: Server,
  ) {}

  /** `base`: the path below which the page lies, with a slash at both ends. */
  static async start(base = '/', headers: Record<string, string> = {}): Promise<StaticHost> {
    const folder = mkdtempSync(join(tmpdir(), 'formicarium-host-'))
    cpSync(DIST, folder, { recursive: true })
    const server = createServer()
    server.listen(0, 'localhost')
    await once(server, 'listening')
    const { port } = server.address() as AddressInfo
    const host = new StaticHost(folder, `http://localhost:${port}${base}`, base, server)
    server.on('request', ({ url = '/' }, response) => host.answer(url, response, headers))
    return host
  }

  stop(): void {
    this.server.close()
    this.server.closeAllConnections()
  }

  remove(): void {
    this.stop()
    rmSync(this.folder, { recursive: true })
  }

  /** Changes a file of the page. */
  change(name: string, how: (content: string) => string): void {
    const file = join(this.folder, name)
    writeFileSync(file, how(readFileSync(file, 'utf8')))
  }

  /** Whether every request fails from now on, as on a bad line. */
  breakConnections(broken: boolean): void {
    this.isBroken = broken
  }

  private answer(url: string, response: ServerResponse, headers: Record<string, string>): void {
    if (this.isBroken) {
      response.destroy()
      return
    }
    const path = decodeURIComponent(new URL(url, 'http://host/').pathname)
    this.asked.push(path)
    const name = path.startsWith(this.base) ? path.slice(this.base.length) || 'index.html' : ''
    try {
      const content = readFileSync(join(this.folder, name))
      response.writeHead(200, {
        'content-type': TYPES[extname(name)] ?? 'text/plain',
        'cache-control': name.startsWith('assets/') ? FOR_A_YEAR : 'no-cache',
        ...headers,
      })
      response.end(content)
    } catch {
      response.writeHead(404).end('not here')
    }
  }
}
