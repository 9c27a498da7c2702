/**
 * The page as one file (docs/one_file.md): one script without lazy parts, one style, and the workers, as the shell and the parts that
 * `cargo xtask build` packs into `one-file.html`.
 */
import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { inOneScript } from './one_file_parts.ts'
import { shellAndParts } from './one_file_shell.ts'
import { shared } from './vite.config.ts'

const { plugins, ...page } = shared()

export default defineConfig({
  ...page,
  publicDir: false,
  plugins: [inOneScript(), ...plugins, shellAndParts()],
  build: {
    target: 'es2022',
    outDir: '../target/one-file',
    emptyOutDir: true,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: Number.MAX_SAFE_INTEGER,
    rolldownOptions: {
      input: fileURLToPath(new URL('src/app/one_file.ts', import.meta.url)),
      output: { format: 'es', codeSplitting: false },
    },
  },
})
