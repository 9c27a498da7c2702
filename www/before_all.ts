/**
 * before_all.js stands in the page itself and starts it: a browser that cannot run the page fetches nothing of it and is told why, in any
 * language that it can read.
 */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { minifySync, type Plugin } from 'vite'

const PLACE = '<!--before-all-->'
const MODULE = /\s*<script type="module" crossorigin src="([^"]+)"><\/script>/
const PRELOADED = /\s*<link rel="modulepreload" crossorigin href="([^"]+)">/g

export function beforeAll(): Plugin {
  let serves = false
  return {
    name: 'formicarium:before-all',
    configResolved({ command }) {
      serves = command === 'serve'
    },
    transformIndexHtml: {
      order: 'post',
      // While one edits, the page's script stands where Vite wants it.
      handler: (html) => (serves ? filled(html, []) : started(html)),
    },
  }
}

/** With the scripts that the page begins with taken out and named to before_all.js. */
function started(html: string): string {
  const [, first] = MODULE.exec(html) ?? []
  if (!first) throw new Error('the page has no script to begin with')
  const others = [...html.matchAll(PRELOADED)].map(([, address = '']) => address)
  return filled(html.replace(MODULE, '').replace(PRELOADED, ''), [first, ...others])
}

const filled = (html: string, scripts: string[]) =>
  html.replace(PLACE, () => `<script>${beforeAllScript(scripts)}</script>`)

/** `scripts`: null for the page in one file, none while one edits. */
export function beforeAllScript(scripts: string[] | null): string {
  const file = fileURLToPath(new URL('before_all.js', import.meta.url))
  const code = readFileSync(file, 'utf8').replace('SCRIPTS', JSON.stringify(scripts))
  return minifySync(file, code, { compress: { target: 'es2015' } }).code
}
