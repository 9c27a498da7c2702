/**
 * Parts of the page are fetched by src/engine/fetch_part.ts instead of Vite's own helper. Vite names the files of a part only where it has
 * several, and never the small file in which the bundler keeps what it adds to modules; here each part has all its names.
 */

import { basename } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Plugin } from 'vite'
import { withAllNames } from './part_names.ts'

/** How Vite calls its helper, and the module that has it. */
const HELPER = { id: '\0vite/preload-helper.js', name: '__vitePreload' }

const OURS = fileURLToPath(new URL('src/engine/fetch_part.ts', import.meta.url))

export function partsOfPage(): Plugin {
  return {
    name: 'formicarium:parts-of-page',
    apply: 'build',
    enforce: 'post',
    load: {
      order: 'pre',
      handler: (id) =>
        id === HELPER.id
          ? `export { fetchPart as ${HELPER.name} } from ${JSON.stringify(OURS)}`
          : null,
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const chunks = Object.values(bundle).filter((each) => each.type === 'chunk')
        const known = new Map(
          chunks.map((each) => [
            basename(each.fileName),
            each.imports.map((file) => basename(file)),
          ]),
        )
        for (const chunk of chunks)
          chunk.code = withAllNames(
            chunk.code,
            basename(chunk.fileName),
            (file) => known.get(file) ?? [],
          )
      },
    },
  }
}
