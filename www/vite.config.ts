import { watchFile } from 'node:fs'
import { fileURLToPath } from 'node:url'
import preact from '@preact/preset-vite'
import { defineConfig, type Plugin } from 'vite'
import { chartNumbers } from './chart_numbers.ts'
import { contentSecurity } from './content_security.ts'
import { paperCards } from './paper_cards.ts'
import { paperQuestions } from './paper_questions.ts'
import { socialTags } from './social_tags.ts'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))
const pkg = path('../pkg')

/** With all that they import: words, and what of the stage and of lazy parts the opening page has. */
const NEEDED =
  /src.(words.(gap|planner|height|place|objective)_words|ui.lazily|stage.(stage|keyboard|pointer)\.)/

/** What begins before the rest has been read. */
const EARLY = /src.engine.(early|load|new_worker)\.|src.model.errors\./

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

export default defineConfig({
  // Relative addresses: the built folder works on any host and any sub-path.
  base: './',
  plugins: [
    preact(),
    reloadOnNewEngine(),
    paperCards(),
    paperQuestions(),
    chartNumbers(),
    socialTags(),
    contentSecurity(),
  ],
  resolve: { alias: { '@pkg': pkg } },
  server: { fs: { allow: [path('..')] } },
  build: {
    target: 'es2022',
    sourcemap: false,
    // Browsers that know no preloading load the same a little later.
    modulePreload: { polyfill: false },
    // What every visit needs is one file: cut up by which late part needs what, it would be larger by kilobytes.
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            { name: 'early', test: EARLY, priority: 1 },
            { name: 'page', test: NEEDED },
          ],
        },
      },
    },
  },
  worker: { format: 'es' },
})
