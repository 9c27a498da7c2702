import { watchFile } from 'node:fs'
import { fileURLToPath } from 'node:url'
import preact from '@preact/preset-vite'
import { defineConfig, type Plugin } from 'vite'
import { beforeAll } from './before_all.ts'
import { chartNumbers } from './chart_numbers.ts'
import { contentSecurity } from './content_security.ts'
import { paperCards } from './paper_cards.ts'
import { paperQuestions } from './paper_questions.ts'
import { partsOfPage } from './parts_of_page.ts'
import { socialTags } from './social_tags.ts'
import { versionOfPage } from './version_of_page.ts'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))
const pkg = path('../pkg')

/** With all that they import: words, and what of the stage and of lazy parts the opening page has. */
const NEEDED =
  /src.(words.((gap|planner|objective)_words|lengths)\.|ui.lazily|stage.(stage|keyboard|pointer)\.)/

/** What begins before the rest has been read. */
const EARLY = /src.engine.(early|load|files_of_page|fetch_part|new_worker)\.|src.model.errors\./

/** Small, and wanted by several late parts: one file, so that the page has fewer names of files to know. */
const LATE =
  /src.share.(deflate|envelope|link_error|byte_stream)\.|src.i18n.(lists|embed)\.|src.i18n.en.embed\.|src.model.(script_error|embedding)\.|src.state.clipboard\.|lucide.*icons.(copy|image|chevron-right|scissors)\./

/** Files that every visit has by the time it asks for others. */
const OPENED = /(page|early|rolldown-runtime)-[^/]*\.js$/

/** `cargo xtask serve --dev` writes pkg/.stamp last: the engine is new, so is the page. */
function reloadOnNewEngine(): Plugin {
  return {
    name: 'formicarium:reload-on-new-engine',
    apply: 'serve',
    configureServer(server) {
      watchFile(`${pkg}/.stamp`, { interval: 300, persistent: false }, (now) => {
        if (now.mtimeMs === 0) return
        server.moduleGraph.invalidateAll()
        server.ws.send({ type: 'full-reload' })
      })
    },
  }
}

/** What every build of the page has; one_file.config.ts is the other. */
export const shared = () => ({
  // Relative addresses: the built folder works on any host and any sub-path.
  base: './',
  plugins: [preact(), paperCards(), paperQuestions(), chartNumbers()],
  resolve: { alias: { '@pkg': pkg } },
})

const { plugins, ...page } = shared()

export default defineConfig({
  ...page,
  plugins: [
    ...plugins,
    reloadOnNewEngine(),
    partsOfPage(),
    versionOfPage(pkg),
    socialTags(),
    beforeAll(),
    contentSecurity(),
  ],
  server: { fs: { allow: [path('..')] } },
  build: {
    target: 'es2022',
    sourcemap: false,
    license: { fileName: 'licences-of-page.json' },
    modulePreload: {
      // Browsers without it only begin a little later.
      polyfill: false,
      resolveDependencies: (_, files, { hostType }) =>
        hostType === 'html' ? files : files.filter((file) => !OPENED.test(file)),
    },
    // What every visit needs is one file: cut up by which late part needs what, it would be larger by kilobytes.
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            { name: 'early', test: EARLY, priority: 1 },
            { name: 'page', test: NEEDED },
            { name: 'late', test: LATE },
          ],
        },
      },
    },
  },
  worker: { format: 'es' },
})
