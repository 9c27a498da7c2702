/**
 * What the page otherwise fetches by its address is inside the one file: workers and the engine become parts, which its loader
 * (src/one_file/loader.ts) has unpacked before the page begins. Only the whole engine is there; it stands for the core too.
 */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { build, type Plugin } from 'vite'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))

/** A worker and the file it is made of; the core's is the whole one's. */
const WORKERS: Record<string, string> = {
  core: 'whole',
  whole: 'whole',
  pool: 'pool',
  analyst: 'analyst',
}
const ENGINE = 'formicarium_bg.wasm'
const LICENCES = 'licences.txt'

/** The engine of the one file: the whole one, small rather than fast. All else of the package is the page's. */
export const smallEngine = {
  find: /^@pkg\/formicarium$/,
  replacement: path('../pkg/small/formicarium'),
}

const MARK = '\0one-file:'

/** Pictures of the cards, which the page fetches one by one. */
const FETCHED = '?url&no-inline'

export function inOneScript(): Plugin {
  return {
    name: 'formicarium:in-one-script',
    enforce: 'pre',
    resolveId(id) {
      if (id.endsWith(`${ENGINE}?url`)) return `${MARK}engine`
      const worker = /(\w+)\.worker\?worker&url$/.exec(id)?.[1]
      return worker ? `${MARK}worker:${WORKERS[worker]}` : undefined
    },
    load(id) {
      if (!id.startsWith(MARK)) return undefined
      const [, kind, name] = id.slice(1).split(':')
      return kind === 'engine'
        ? addressOf(ENGINE, 'application/wasm')
        : addressOf(`${name}.worker.js`, 'text/javascript')
    },
    transform(code, id) {
      if (!id.endsWith('dialogs/markdown.tsx')) return undefined
      if (!code.includes(FETCHED))
        this.error(`the cards' pictures are no longer ${FETCHED}: see ${import.meta.filename}`)
      return { code: code.replace(FETCHED, '?url&inline'), map: null }
    },
  }
}

/** A module that gives the address of a part. */
const addressOf = (name: string, type: string) =>
  `import { partAddress } from '/src/model/one_file'
export default partAddress('${name}', '${type}')`

/** A part of the file, by the name that the page asks for. */
export interface Part {
  name: string
  bytes: Uint8Array
}

/** Whose works the page contains, as the build of the page has written it. */
function licences(): Part {
  const file = process.env.FORMICARIUM_LICENCES
  if (!file) throw new Error('the page of one file is built by cargo xtask build')
  return { name: LICENCES, bytes: readFileSync(file) }
}

/** The workers, the engine and what must go along with them; what is alike side by side. */
export async function builtParts(): Promise<Part[]> {
  const parts: Part[] = []
  for (const name of new Set(Object.values(WORKERS)))
    parts.push({
      name: `${name}.worker.js`,
      bytes: await scriptOf(`src/worker/${name}.worker.ts`),
    })
  const engine = { name: ENGINE, bytes: readFileSync(path(`../pkg/small/${ENGINE}`)) }
  return [...parts, licences(), engine]
}

/** One script that needs no other, made of a file and all that it imports. */
export async function scriptOf(file: string): Promise<Uint8Array> {
  const built = await build({
    configFile: false,
    root: path('.'),
    logLevel: 'warn',
    resolve: { alias: [smallEngine, { find: '@pkg', replacement: path('../pkg') }] },
    build: {
      write: false,
      target: 'es2022',
      // As a library: nothing of it waits for files beside it.
      lib: { entry: path(file), formats: ['iife'], name: 'part' },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  })
  const outputs = [built].flat().flatMap((one) => ('output' in one ? one.output : []))
  const [script] = outputs
  if (outputs.length !== 1 || script?.type !== 'chunk')
    throw new Error(`${file} has become more than one script`)
  return new TextEncoder().encode(script.code)
}
