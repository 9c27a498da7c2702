// A server of files for a browser that is measured: below the repository's root, or below a folder of it.
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { gzipSync } from 'node:zlib'

const TYPES = {
  css: 'text/css',
  html: 'text/html',
  js: 'text/javascript',
  mjs: 'text/javascript',
  wasm: 'application/wasm',
  woff2: 'font/woff2',
}

/** What is compressed already. */
const PACKED = new Set(['woff2'])

/**
 * Serves the files below `folder` (a URL), compressed as static hosts do when `packed`; `blank` answers at the root with an empty page.
 * With these headers a page's clock has its full resolution.
 */
export async function serveFiles(folder, { packed = false, blank = false } = {}) {
  const known = new Map()
  const fileOf = (path) => {
    const ending = path.split('.').at(-1)
    const bytes = readFileSync(new URL(path, folder))
    const gzip = packed && !PACKED.has(ending)
    return { type: TYPES[ending] ?? 'text/plain', gzip, bytes: gzip ? gzipSync(bytes) : bytes }
  }
  const server = createServer((request, response) => {
    const path = request.url.slice(1).split(/[?#]/)[0] || 'index.html'
    response.setHeader('Cross-Origin-Opener-Policy', 'same-origin')
    response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp')
    if (blank && path === 'index.html')
      return response.setHeader('Content-Type', TYPES.html).end('<!doctype html>')
    try {
      if (!known.has(path)) known.set(path, fileOf(path))
      const { type, gzip, bytes } = known.get(path)
      if (gzip) response.setHeader('Content-Encoding', 'gzip')
      response.setHeader('Content-Type', type).end(bytes)
    } catch {
      response.writeHead(404).end()
    }
  })
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready))
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() }
}
