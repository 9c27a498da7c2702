/** The npm package as whoever installs it has it: packed, installed without a network, run in Node.js and in a page. */
import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { extname, join, normalize } from 'node:path'
import { expect, test } from '@playwright/test'
import { blocksOf, docText } from './doc_blocks'
import { home } from './parent_page'

const ROOT = join(__dirname, '../..')
const TEXT = docText('embedding.md')
const NODE_EXAMPLE = blocksOf(TEXT, 'js').at(-1) ?? ''
const PAGE_EXAMPLE = blocksOf(TEXT, 'html').at(-1) ?? ''
const MAP = 'S....\n.###.\n....G\n'

let place = ''
let server: Server

test.beforeAll(async () => {
  place = mkdtempSync(join(tmpdir(), 'package-'))
  const npm = (...args: string[]) => execFileSync('npm', args, { cwd: place, encoding: 'utf8' })
  const [packed] = JSON.parse(npm('pack', join(ROOT, 'pkg'), '--json', '--pack-destination', place))
  writeFileSync(join(place, 'package.json'), '{ "private": true, "type": "module" }')
  npm('install', '--offline', '--no-audit', '--no-fund', `./${packed.filename}`)
  server = await serveFolder(place)
})
test.afterAll(() => {
  server?.close()
  rmSync(place, { recursive: true, force: true })
})

const TYPES: Record<string, string> = { '.html': 'text/html', '.js': 'text/javascript' }

/** Files below a folder, on a site that is not ours. */
async function serveFolder(folder: string): Promise<Server> {
  const serving = createServer((request, answer) => {
    const path = join(folder, normalize(new URL(request.url ?? '', 'http://x').pathname))
    if (!path.startsWith(folder) || !existsSync(path)) {
      answer.statusCode = 404
      answer.end()
      return
    }
    answer.setHeader('content-type', TYPES[extname(path)] ?? 'application/octet-stream')
    answer.end(readFileSync(path))
  })
  await new Promise<void>((resolve) => serving.listen(0, '127.0.0.1', resolve))
  return serving
}

/** What the command line says of the same run. */
function byCommandLine(args: string[]): { length: number; digest: string } {
  const map = join(place, 'small.txt')
  writeFileSync(map, MAP)
  const cli = process.env.FORMICARIUM_CLI ?? join(ROOT, 'target/debug/formicarium')
  const said = execFileSync(cli, ['plan', map, '--format', 'json', ...args], { encoding: 'utf8' })
  const { metrics, digest } = JSON.parse(said)
  return { length: metrics.length, digest }
}

test('the example for Node.js prints what the command line finds', () => {
  writeFileSync(join(place, 'plan.js'), NODE_EXAMPLE)
  const said = execFileSync(process.execPath, ['plan.js'], { cwd: place, encoding: 'utf8' })
  const { length, digest } = byCommandLine([
    ...['--planner', 'ant-system', '--seed', '7'],
    ...['--set', 'ants=6', '--set', 'iterations=10'],
  ])
  expect(said.trim()).toBe(`${length} ${digest}`)
})

test('the element can be imported where there is no document', () => {
  writeFileSync(join(place, 'element.js'), "import 'formicarium/race'\nconsole.log('imported')\n")
  const said = execFileSync(process.execPath, ['element.js'], { cwd: place, encoding: 'utf8' })
  expect(said.trim()).toBe('imported')
})

test('the types of the package hold for a program that uses all of it', () => {
  writeFileSync(
    join(place, 'typed.ts'),
    `import type { RunSummary } from 'formicarium'
import { FormicariumRace, type PanelResult } from 'formicarium/race'

const race = document.createElement('formicarium-race')
race.addEventListener('better-path', ({ detail }) => detail.length?.toFixed(2))
race.addEventListener('error', ({ detail }) => detail.hint.trim())
const results: PanelResult[] = await race.run({ iterations: 3 })
const summary: RunSummary | null | undefined = results[0]?.summary
export const digest = (summary?.digest ?? '') + FormicariumRace.name
// @ts-expect-error: there is no such option
await race.run({ iteration: 3 })
// @ts-expect-error: nor such a file
await race.resultFile('pdf')
`,
  )
  const tsc = join(ROOT, 'www/node_modules/typescript/bin/tsc')
  for (const [module, resolution] of [
    ['esnext', 'bundler'],
    ['nodenext', 'nodenext'],
  ] as const) {
    const options = ['--noEmit', '--strict', '--target', 'es2023', '--lib', 'esnext,dom']
    const how = ['--module', module, '--moduleResolution', resolution, '--types', '']
    execFileSync(process.execPath, [tsc, ...options, ...how, 'typed.ts'], {
      cwd: place,
      encoding: 'utf8',
    })
  }
})

/** The example with the page that the tests serve, and names of modules for a browser without a bundler. */
function exampleIn(html: string): void {
  const imports = { imports: { 'formicarium/race': './node_modules/formicarium/element/race.js' } }
  writeFileSync(
    join(place, 'example.html'),
    `<!doctype html><html lang="en"><title>Lecture 7</title>
    <script type="importmap">${JSON.stringify(imports)}</script>
    ${html.replace('./formicarium/', home())}`,
  )
}

const exampleAddress = () =>
  `http://127.0.0.1:${(server.address() as AddressInfo).port}/example.html`

test('the example for a page runs as it stands, from the packed package', async ({ page }) => {
  exampleIn(PAGE_EXAMPLE)
  await page.goto(exampleAddress())
  const output = page.locator('output')
  // The search has ended.
  await expect(output).toHaveText(/^[\d.]+ [0-9a-f]{16}$/)
  const digests = await page.evaluate(async () => {
    const race = document.querySelector('formicarium-race') as unknown as {
      ready: Promise<void>
      run(): Promise<{ planner: string; summary: { digest: string } }[]>
    }
    await race.ready
    return (await race.run()).map(({ planner, summary }) => [planner, summary.digest])
  })
  const { digest, length } = byCommandLine(['--planner', 'astar', '--seed', '1'])
  expect(digests).toContainEqual(['astar', digest])
  expect(length).toBeGreaterThan(5)
})

test('the element opens its source, follows its attributes and tells what is wrong', async ({
  page,
}) => {
  test.slow()
  exampleIn('<script type="module">import "formicarium/race"</script>')
  writeFileSync(join(place, 'small.map'), 'type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n')
  cpSync(join(place, 'small.map'), join(place, 'again.map'))
  await page.goto(exampleAddress())
  const told = await page.evaluate(async (at) => {
    await customElements.whenDefined('formicarium-race')
    // biome-ignore lint/suspicious/noExplicitAny: the package is not known to the tests
    const race = document.createElement('formicarium-race') as any
    const errors: string[] = []
    race.addEventListener('error', ({ detail }: CustomEvent) => errors.push(detail.kind))
    const before = await race.results().catch(({ kind }: { kind: string }) => kind)
    document.body.append(race)
    race.setAttribute('src', './small.map')
    race.setAttribute('page', at)
    race.setAttribute('controls', 'numbers play')
    await race.ready
    const width = (await race.session()).scenario.spec.width
    const refused = await race
      .run({ iteration: 1 })
      .catch((error: Error) => [
        error instanceof Error,
        (error as unknown as { kind: string }).kind,
      ])
    const frame = race.shadowRoot.querySelector('iframe')
    const query = new URL(frame.src).search
    const waiting = race.run().catch(({ kind }: { kind: string }) => kind)
    race.setAttribute('src', './nowhere.map')
    await race.ready
    const { height, width: wide } = race.getBoundingClientRect()
    return {
      before,
      width,
      refused,
      query,
      left: await waiting,
      errors,
      size: [height, wide > 300],
    }
  }, home())
  expect(told.before).toBe('no-frame')
  expect(told.width).toBe(3)
  expect(told.refused).toEqual([true, 'unknown-option'])
  const origin = encodeURIComponent(new URL(exampleAddress()).origin)
  expect(told.query).toBe(`?embed=play,numbers&origin=${origin}`)
  expect(told.left).toBe('frame-left')
  expect(told.errors.at(-1)).toBe('not-fetched')
  expect(told.size).toEqual([480, true])
})

test('a share link in the element goes into the frame, and its text is opened', async ({
  page,
}) => {
  exampleIn('<script type="module">import "formicarium/race"</script>')
  await page.goto(exampleAddress())
  const widths = await page.evaluate(
    async ([at, text]) => {
      await customElements.whenDefined('formicarium-race')
      const width = async (src: string) => {
        // biome-ignore lint/suspicious/noExplicitAny: the package is not known to the tests
        const race = document.createElement('formicarium-race') as any
        race.setAttribute('page', at)
        race.setAttribute('src', src)
        document.body.append(race)
        await race.ready
        const session = await race.session()
        const address = race.shadowRoot.querySelector('iframe').src
        race.remove()
        return [session?.scenario.spec.width ?? null, address.includes('#x=')]
      }
      return [await width(text), await width(`${at}#x=rubbish`)]
    },
    [home(), MAP] as const,
  )
  expect(widths).toEqual([
    [5, false],
    [null, true],
  ])
})
