/** Builds sw.js into the folder of the built page, last of all: it has the names of all files there. */
import { createHash } from 'node:crypto'
import { readdirSync, readFileSync } from 'node:fs'
import { join, relative, sep } from 'node:path'
import { fileURLToPath } from 'node:url'
import { defineConfig, type Plugin } from 'vite'

const MODULE = 'virtual:files-of-page'
const OUTPUT = 'sw.js'
/** For programs that show cards of links. */
const NOT_KEPT = [OUTPUT, 'social.png', '404.html']
/** Vite gives these a name of their own for each content. */
const NAMED_BY_CONTENT = /^assets\//

function filesOfPage(): Plugin {
  let folder = ''
  return {
    name: 'formicarium:files-of-page',
    configResolved({ root, build }) {
      folder = join(root, build.outDir)
      if (build.outDir.startsWith(sep)) folder = build.outDir
    },
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : null),
    load: (id) => (id === `\0${MODULE}` ? listOf(folder) : null),
  }
}

function listOf(folder: string): string {
  let bytes = 0
  const all = createHash('sha256')
  const files = namesIn(folder).map((url) => {
    const content = readFileSync(join(folder, url))
    const hash = createHash('sha256').update(content).digest()
    const revision = hash.toString('hex').slice(0, 16)
    bytes += content.length
    all.update(`${url} ${revision}\n`)
    // What is not exactly this file is not kept: a host may answer with something else while a version is put up.
    const integrity = `sha256-${hash.toString('base64')}`
    return { url, revision: NAMED_BY_CONTENT.test(url) ? null : revision, integrity }
  })
  const version = all.digest('hex').slice(0, 16)
  return Object.entries({ files, version, bytes })
    .map(([name, value]) => `export const ${name} = ${JSON.stringify(value)}`)
    .join('\n')
}

const namesIn = (folder: string) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !NOT_KEPT.includes(entry.name))
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .sort()

export default defineConfig({
  plugins: [filesOfPage()],
  // Silent: what it does can be asked for.
  define: { 'process.env.NODE_ENV': '"production"' },
  publicDir: false,
  build: {
    target: 'es2022',
    emptyOutDir: false,
    lib: {
      entry: fileURLToPath(new URL('src/offline/service.worker.ts', import.meta.url)),
      formats: ['iife'],
      name: 'formicarium',
      fileName: () => OUTPUT,
    },
  },
})
