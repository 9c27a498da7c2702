/** A host of static files as docs/hosting.md describes it, below a path. */
import { existsSync, readFileSync, statSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import { extname, join, normalize } from 'node:path'
import { gzipSync } from 'node:zlib'

const ROOT = join(__dirname, '../..')
const DIST = join(ROOT, 'www/dist')
const BASE = '/a/path/ants/'

const TYPES: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.png': 'image/png',
  '.woff2': 'font/woff2',
  '.webmanifest': 'application/manifest+json',
}

/** The headers of the docs, with the hashes of the built page. */
export function headersOfDocs(): Record<string, string> {
  const docs = readFileSync(join(ROOT, 'docs/hosting.md'), 'utf8')
  const [, block = ''] = /```headers\n([\s\S]*?)```/.exec(docs) ?? []
  const page = readFileSync(join(DIST, 'index.html'), 'utf8').replaceAll('&#39;', "'")
  const hashes = new Set(page.match(/'sha256-[^']*'/g))
  return Object.fromEntries(
    block
      .trim()
      .split('\n')
      .map((line) => [
        line.slice(0, line.indexOf(': ')),
        line.slice(line.indexOf(': ') + 2).replace("'sha256-…'", [...hashes].join(' ')),
      ]),
  )
}

/** Its address, and how to stop it. */
export async function startHost(): Promise<{ address: string; stop: () => void }> {
  const headers = headersOfDocs()
  const server: Server = createServer(({ url = '' }, response) => {
    const { pathname } = new URL(url, 'http://localhost')
    const within = normalize(decodeURIComponent(pathname.slice(BASE.length))) || 'index.html'
    const file = join(DIST, within === '.' ? 'index.html' : within)
    if (!pathname.startsWith(BASE) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end()
      return
    }
    const isAsset = within.startsWith('assets/')
    response.writeHead(200, {
      ...headers,
      'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream',
      'Content-Encoding': 'gzip',
      'Cache-Control': isAsset ? 'public, max-age=31536000, immutable' : 'no-cache',
    })
    response.end(gzipSync(readFileSync(file), { level: 1 }))
  })
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
  const address = server.address()
  const port = typeof address === 'object' && address ? address.port : 0
  return { address: `http://127.0.0.1:${port}${BASE}`, stop: () => server.close() }
}
