/**
 * Writes what `cargo xtask build` makes `one-file.html` of: `shell.html`, the page around its packed parts with its own
 * Content-Security-Policy, and `parts.bin`, which is packed into it. docs/formats.md describes both.
 */
import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import type { Plugin, Rolldown } from 'vite'
import { beforeAllScript } from './before_all.ts'
import { builtParts, type Part, scriptOf } from './one_file_parts.ts'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))

export function shellAndParts(): Plugin {
  return {
    name: 'formicarium:shell-and-parts',
    apply: 'build',
    generateBundle: {
      // Once Vite has written the script to its end.
      order: 'post',
      async handler(_, bundle) {
        const { script, style } = takenFrom(bundle)
        const parts = [...(await builtParts()), part('page.js', script), part('page.css', style)]
        const loader = new TextDecoder().decode(await scriptOf('src/one_file/loader.ts'))
        const shell = shellOf({ loader, script, style })
        this.emitFile({ type: 'asset', fileName: 'shell.html', source: shell })
        this.emitFile({ type: 'asset', fileName: 'parts.bin', source: joined(parts) })
      },
    },
  }
}

/** The page's one script and its one style; nothing else may be left. */
function takenFrom(bundle: Rolldown.OutputBundle): { script: string; style: string } {
  let script = ''
  let style = ''
  for (const [name, output] of Object.entries(bundle)) {
    if (output.type === 'chunk' && script === '') script = output.code
    else if (output.type === 'asset' && name.endsWith('.css')) style = String(output.source)
    else throw new Error(`${name} would lie beside the one file`)
    delete bundle[name]
  }
  return { script, style }
}

const part = (name: string, text: string): Part => ({ name, bytes: new TextEncoder().encode(text) })

/** u32 length of the list (little endian) · the list as JSON, `[name, length]` each · the parts. */
function joined(parts: Part[]): Uint8Array {
  const list = new TextEncoder().encode(
    JSON.stringify(parts.map(({ name, bytes }) => [name, bytes.length])),
  )
  const length = new Uint8Array(4)
  new DataView(length.buffer).setUint32(0, list.length, true)
  return Buffer.concat([length, list, ...parts.map(({ bytes }) => bytes)])
}

interface Texts {
  loader: string
  script: string
  style: string
}

/** Written as browsers write a document out, so that a page that is saved again is the same text. */
function shellOf({ loader, script, style }: Texts): string {
  const splash = readFileSync(path('src/styles/unpacking.css'), 'utf8')
  const before = beforeAllScript(null)
  const policy = policyOf([before, loader, script], [splash, style])
  const values: Record<string, string> = {
    policy,
    head: headOfPage(),
    before,
    splash,
    loader,
    version: JSON.parse(readFileSync(path('../pkg/package.json'), 'utf8')).version,
  }
  const shell = readFileSync(path('one_file.html'), 'utf8').trimEnd()
  return shell.replace(/%(\w+)%/g, (mark, name: string) => values[name] ?? mark)
}

/** Nothing of the network: its own texts by their hashes, and what it makes of its parts. */
function policyOf(scripts: string[], styles: string[]): string {
  const policy: Record<string, string[]> = {
    'default-src': ["'none'"],
    'script-src': ["'wasm-unsafe-eval'", ...scripts.map(hashOf)],
    'style-src': styles.map(hashOf),
    'worker-src': ['blob:'],
    'connect-src': ['blob:', 'data:'],
    'font-src': ['data:'],
    'img-src': ['blob:', 'data:'],
    'base-uri': ["'none'"],
    'form-action': ["'none'"],
  }
  return Object.entries(policy)
    .map(([name, all]) => [name, ...all].join(' '))
    .join('; ')
}

const hashOf = (text: string) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`

/** What the head of index.html says of the page, without what would have to be fetched: its metas, and its icon. */
function headOfPage(): string {
  const page = readFileSync(path('index.html'), 'utf8')
  const tags = page.match(/<(?:meta|link rel="icon")[^>]*>|<link\s[^>]*>/g) ?? []
  return tags
    .filter((tag) => !/charset|rel="manifest"|property="og:|name="twitter:/.test(tag))
    .map((tag) => tag.replace(/\s+/g, ' ').replace(/ ?\/?>$/, '>'))
    .join('\n')
}
