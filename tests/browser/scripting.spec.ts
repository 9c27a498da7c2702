/** Every block of docs/scripting.md, run as it stands; and what scripts are refused. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { asScript, blocksOf, docText } from './doc_blocks'
import { RacePage } from './race_page'
import { zipOf } from './zips'

const TEXT = docText('scripting.md')
const BLOCKS = blocksOf(TEXT, 'js')

test('every block of the page about scripting gives what it says', async ({ page }) => {
  test.slow()
  await new RacePage(page).openAtRest()
  expect(BLOCKS.length).toBeGreaterThan(7)
  const { code, values } = asScript(BLOCKS)
  const told = (await page.evaluate(code)) as [string, unknown, unknown][]
  expect(values).toBeGreaterThan(20)
  expect(told).toHaveLength(values)
  for (const [what, given, expected] of told) expect(given, what).toEqual(expected)
})

test('the page about scripting names every call and every kind of refusal', async ({ page }) => {
  await new RacePage(page).open()
  const calls = await page.evaluate(() => Object.keys(window.formicarium))
  for (const call of calls) expect(TEXT).toContain(`\`${call}`.replace('`version', '`version`'))
  const source = join(__dirname, '../../www/src')
  const files = ['state/script_files.ts', 'lab/scripting.ts', 'app/script_calls.ts']
  const kinds = files.flatMap((file) =>
    [...readFileSync(join(source, file), 'utf8').matchAll(/ScriptError\('([\w-]+)'/g)].map(
      ([, kind = '']) => kind,
    ),
  )
  expect(kinds.length).toBeGreaterThan(10)
  for (const kind of kinds) expect(TEXT).toContain(`\`${kind}\``)
})

interface Refusal {
  kind: string
  field: string
  message: string
  hint: string
}

/** What a call is refused with; its code is run in the page. */
async function refusal(page: Page, code: string): Promise<Refusal> {
  const told = await page.evaluate(`${code}.then(
    () => null,
    (error) => error instanceof Error && { kind: error.kind, field: error.field, message: error.message, hint: error.hint },
  )`)
  expect(told, code).toBeTruthy()
  const refused = told as Refusal
  expect(refused.message, code).not.toBe('')
  expect(refused.hint, code).not.toBe('')
  return refused
}

const REFUSED: [code: string, kind: string, field: string][] = [
  ['formicarium.load("")', 'unknown-format', 'file'],
  ['formicarium.load([])', 'nothing-to-open', 'source'],
  ['formicarium.load(3)', 'bad-option', 'source'],
  ['formicarium.load(null)', 'bad-option', 'source'],
  ['formicarium.load(["a.map"])', 'bad-option', 'source'],
  ['formicarium.load("https://example.org/#x=rubbish")', 'link-damaged', ''],
  ['formicarium.load("S..\\n.#.\\n..G\\n", { row: 3 })', 'unused-option', 'row'],
  ['formicarium.load("S..\\n.#.\\n..G\\n", { rows: 3 })', 'unknown-option', 'rows'],
  ['formicarium.load("S..\\n.#.\\n..G\\n", { usual: 1 })', 'bad-option', 'usual'],
  ['formicarium.load({ ...formicarium.session(), speed: 99 })', 'link-invalid', 'session.speed'],
  ['formicarium.run({ iterations: -1 })', 'bad-option', 'iterations'],
  ['formicarium.run({ iterations: 1.5 })', 'bad-option', 'iterations'],
  ['formicarium.run(20)', 'bad-option', 'run'],
  ['formicarium.look("now")', 'bad-option', 'iteration'],
  ['formicarium.look()', 'bad-option', 'iteration'],
  ['formicarium.resultFile("csv")', 'no-comparison', ''],
  ['formicarium.resultFile("pdf")', 'unknown-file', 'file'],
  ['formicarium.resultFile("csv", "de")', 'bad-option', 'language'],
  ['formicarium.compare({ seed: 3 })', 'unknown-option', 'seed'],
  ['formicarium.compare({ seeds: 0 })', 'bad-option', 'seeds'],
  ['formicarium.compare({ seeds: { count: 3 } })', 'bad-option', 'seeds.from'],
  ['formicarium.compare({ planners: [] })', 'bad-option', 'planners'],
  ['formicarium.compare({ planners: "astar" })', 'bad-option', 'planners'],
  ['formicarium.compare({ planners: [{ planner: "astar", seed: 1 }] })', 'unknown-option', 'seed'],
  [
    'formicarium.compare({ planners: [{ planner: "astar", preset: "ship" }] })',
    'unknown-preset',
    'planners[0].preset',
  ],
  [
    'formicarium.compare({ planners: [{ planner: "ant-system", params: { ant: 1 } }] })',
    'unknown-parameter',
    'planners[0].params.ant',
  ],
  ['formicarium.compare({ maps: ["two-corridor"] })', 'unknown-map', 'maps[0]'],
  ['formicarium.compare({ maps: ["{}"] })', 'version', 'format'],
  ['formicarium.compare({ budget: 100 })', 'bad-option', 'budget'],
  ['formicarium.compare({ budget: { axis: "time", amount: 1 } })', 'bad-option', 'budget.axis'],
  ['formicarium.compare({ untilBudget: true })', 'bad-option', 'untilBudget'],
  ['formicarium.compare({ workers: 0 })', 'bad-option', 'workers'],
  ['formicarium.compare({ document: {} })', 'bad-option', 'document'],
]

test('what a script gets wrong is refused by name, and changes nothing', async ({ page }) => {
  test.slow()
  const race = new RacePage(page)
  await race.openAtRest()
  const before = await race.session()
  for (const [code, kind, field] of REFUSED) {
    const refused = await refusal(page, code)
    expect.soft([refused.kind, refused.field], code).toEqual([kind, field])
  }
  expect(await race.session()).toEqual(before)
  await expect(page.getByTestId('toast-error')).toBeHidden()
})

test('planners out of their range are refused by the engine, by name', async ({ page }) => {
  await new RacePage(page).openAtRest()
  const refused = await refusal(
    page,
    'formicarium.compare({ planners: [{ planner: "ant-system", params: { ants: -3 } }], seeds: 1 })',
  )
  expect(refused.kind).toBe('out-of-range')
})

test('maps may be a session, a link, a text or a file with its options', async ({ page }) => {
  test.slow()
  const race = new RacePage(page)
  await race.openAtRest()
  const link = await race.shareLink()
  const ids = await page.evaluate(async (address) => {
    const session = window.formicarium.session()
    if (!session) throw new Error('no session')
    const { files } = await window.formicarium.compare({
      planners: ['astar'],
      maps: [
        session,
        address,
        'S..\n.#.\n..G\n',
        { source: new File(['0 1\n0 0\n\n0 0\n1 0\n'], 'two.txt'), usual: true },
      ],
      seeds: 1,
    })
    return JSON.parse(files.json).maps.map(({ width }: { width: number }) => width)
  }, link)
  expect(ids).toEqual([36, 36, 3, 2])
})

test('every kind of result file is whole', async ({ page }) => {
  await new RacePage(page).openAtRest()
  const kinds = [...new Set(/`resultFile` gives[^\n]*/.exec(TEXT)?.[0].match(/`[a-z-]+`/g))].map(
    (kind) => kind.slice(1, -1),
  )
  await page.evaluate(() =>
    window.formicarium.compare({
      planners: [{ planner: 'ant-system', params: { ants: 5, iterations: 4 } }, 'astar'],
      seeds: 20,
    }),
  )
  for (const kind of kinds) {
    const text = await page.evaluate((one) => window.formicarium.resultFile(one as 'csv'), kind)
    if (kind === 'claims-csv') {
      expect(text, 'nothing is claimed').toBe('')
      continue
    }
    expect(text.length, kind).toBeGreaterThan(100)
    expect(text, kind).toMatch(/ant-system|Ant System/)
    expect(text, kind).not.toContain('no tests')
  }
  const rows = await page.evaluate(() => window.formicarium.resultFile('csv'))
  expect(rows.trim().split('\n')).toHaveLength(1 + 40)
})

const MAP = 'type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n'
const HEIGHTS = 'ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n'
const PLACES = `NAME: four
TYPE: TSP
DIMENSION: 4
EDGE_WEIGHT_TYPE: EUC_2D
NODE_COORD_SECTION
1 0 0
2 0 3
3 4 3
4 4 0
EOF
`
const RUNS = Array.from({ length: 30 }, (_, at) => `Mine,${at + 1},50\n`)
const RESULTS = `entry,seed,length\n${RUNS.join('')}`

/** Loads a file, and tells what was opened, or what kind of refusal it was and about what. */
async function load(page: Page, name: string, content: string | Buffer, options?: object) {
  const base64 = Buffer.from(content).toString('base64')
  return page.evaluate(
    async ([file, text, given]) => {
      const bytes = Uint8Array.from(atob(text), (char) => char.charCodeAt(0))
      return window.formicarium.load(new File([bytes], file), given).then(
        (opened) => `${opened.kind} ${opened.name}`,
        (error) => `${error.kind}: ${error.field}`,
      )
    },
    [name, base64, options] as const,
  )
}

test('every kind of file that can be dropped is opened, or asked about by name', async ({
  page,
}) => {
  test.slow()
  const race = new RacePage(page)
  await race.openAtRest()
  const width = async () => (await race.session()).scenario.spec.width
  expect(await load(page, 'heights.asc', HEIGHTS)).toBe('choice-needed: part')
  expect(await width()).toBe(36)
  const part = { crop: { x: 1, y: 0, width: 2, height: 2 } }
  expect(await load(page, 'heights.asc', HEIGHTS, { part })).toBe('map heights.asc')
  expect((await race.session()).scenario.heights).toEqual(Float32Array.of(2, 3, 5, 6))
  const two = '0 1\n0 0\n\n0 0 0\n1 0 0\n'
  expect(await load(page, 'two.txt', two)).toBe('choice-needed: read')
  expect(await load(page, 'two.txt', two, { read: { matrix: 2 } })).toBe('map two.txt')
  expect(await width()).toBe(3)
  const both = zipOf([
    ['a.map', MAP],
    ['b.map', MAP.replace('.@.', '..@')],
    ['read.me', 'nothing to open'],
  ])
  expect(await load(page, 'both.zip', both)).toBe('choice-needed: file')
  expect(await load(page, 'both.zip', both, { file: 'c.map' })).toBe('no-such-file: file')
  expect(await load(page, 'both.zip', both, { file: 'a.map' })).toBe('map a.map')
  expect(await race.isWall([1, 1])).toBe(true)
  const one = zipOf([['a.map', MAP]])
  expect(await load(page, 'one.zip', one, { row: 2 })).toBe('unused-option: row')
  expect(await load(page, 'read.me', 'nothing to open')).toMatch(/^unknown-format: /)

  const picture = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(8, 6)
    canvas.getContext('2d')?.fillRect(0, 0, 2, 2)
    const blob = await canvas.convertToBlob()
    const asked = await window.formicarium.load(blob).catch((error) => error.field)
    const opened = await window.formicarium.load(blob, { usual: true })
    return [asked, opened.kind]
  })
  expect(picture).toEqual(['read', 'map'])
  expect(await width()).toBe(8)

  expect(await load(page, 'four.tsp', PLACES)).toBe('order four.tsp')
  await expect(page.locator('dialog')).toContainText('four')
  await race.leaveDialog()
  await load(page, 'a.map', MAP)
  expect(await load(page, 'mine.csv', RESULTS)).toBe('results mine.csv')
  await expect(page.getByTestId('own-file-item')).toContainText('mine.csv')
  const nowhere = { instance: 'nowhere' }
  expect(await load(page, 'theirs.csv', RESULTS, nowhere)).toMatch(/^[\w-]+: (results|instance)/)
  const theirs = RESULTS.replaceAll('Mine', 'Theirs')
  expect(await load(page, 'theirs.csv', theirs, { leaveOut: [] })).toBe('results theirs.csv')
  expect(await load(page, 'a.map', MAP, { leaveOut: [] })).toBe('unused-option: leaveOut')
  await expect(page.getByTestId('toast-error')).toBeHidden()
})
