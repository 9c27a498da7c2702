/**
 * Parts of the page are fetched by src/engine/fetch_part.ts instead of Vite's own helper. Vite names the files of a part only where it has
 * several; here each has its name.
 */
import { fileURLToPath } from 'node:url'
import type { Plugin } from 'vite'

/** How Vite calls its helper, and the module that has it. */
const HELPER = { id: '\0vite/preload-helper.js', name: '__vitePreload' }

const OURS = fileURLToPath(new URL('src/engine/fetch_part.ts', import.meta.url))

/** An import and the list of its files, empty as it stands. */
const ALONE =
  /import\((["'`])(\.\/[^"'`]+)\1\)((?:(?!import\().)*?),(?:\[\]|void 0),(import\.meta\.url\))/gs

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
        for (const chunk of Object.values(bundle)) {
          if (chunk.type !== 'chunk') continue
          chunk.code = chunk.code.replace(
            ALONE,
            (_all, quote, file, between, end) =>
              `import(${quote}${file}${quote})${between},[${quote}${file}${quote}],${end}`,
          )
        }
      },
    },
  }
}
