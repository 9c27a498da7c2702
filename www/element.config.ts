/** Builds the custom element into the package: one module, and its types. `npm run element`; `cargo xtask build` does so after the page. */
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join, relative } from 'node:path'
import { fileURLToPath } from 'node:url'
import { defineConfig, type Plugin } from 'vite'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))
const pkg = path('../pkg')
const out = join(pkg, 'element')
/** The whole page in one file, where the build has made one: then the element needs no other. */
const wholePage = path('dist/one-file.html')
const ownPage = existsSync(wholePage)

/** Types of what they were made from, with the engine's own beside them and the endings that Node.js asks for. */
function declarations(): Plugin {
  return {
    name: 'formicarium:declarations',
    closeBundle() {
      execFileSync(process.execPath, [
        path('node_modules/typescript/bin/tsc'),
        '--project',
        path('tsconfig.element.json'),
      ])
      for (const file of readdirSync(out, { recursive: true, encoding: 'utf8' })) {
        if (!file.endsWith('.d.ts')) continue
        const at = join(out, file)
        const engine = relative(dirname(at), join(pkg, 'formicarium.js')).replaceAll('\\', '/')
        const text = readFileSync(at, 'utf8')
          .replaceAll(/(['"])@pkg\/formicarium\1/g, `'${engine}'`)
          .replaceAll(/from '(\.\.?\/[^']+?)(\.js)?'/g, "from '$1.js'")
        writeFileSync(at, text)
      }
    },
  }
}

rmSync(out, { recursive: true, force: true })
rmSync(join(pkg, 'one-file.html'), { force: true })
if (ownPage) copyFileSync(wholePage, join(pkg, 'one-file.html'))
for (const licence of ['LICENSE-MIT', 'LICENSE-APACHE'])
  copyFileSync(path(`../${licence}`), join(pkg, licence))
copyFileSync(path('../docs/embedding.md'), join(pkg, 'README.md'))

export default defineConfig({
  publicDir: false,
  plugins: [declarations()],
  define: {
    OWN_PAGE: ownPage ? "new URL('../one-file.html', import.meta.url).href" : 'null',
  },
  build: {
    target: 'es2022',
    outDir: out,
    emptyOutDir: false,
    lib: { entry: path('src/element/race.ts'), formats: ['es'], fileName: () => 'race.js' },
  },
})
