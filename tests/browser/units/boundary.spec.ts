/** What a script may pass to the package: every wrong value at every parameter is refused as an EngineError, and nothing breaks. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { expect, test } from '@playwright/test'
import { sessionOf } from './sessions'

const PKG = join(__dirname, '../../../pkg')
const STUDY = join(__dirname, '../../fixtures/links/0.1.0/study.result.json')

type Engine = typeof import('@pkg/formicarium')
type Call = (...args: unknown[]) => unknown

/** An instance of its own. */
async function instance(build: string, turn: string): Promise<Engine> {
  const folder = join(PKG, build)
  const engine = await import(`${join(folder, 'formicarium.js')}?${turn}`)
  engine.initSync({ module: readFileSync(join(folder, 'formicarium_bg.wasm')) })
  return engine
}

const text = (words: string) => new TextEncoder().encode(words)
const terrain = 'ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n2 3 4\n3 4 9\n'
/** A picture of one pixel. */
const pixel = text('P3\n1 1\n255\n9 9 9\n')
const lattice = { x0: 0, y0: 0, dx: 3, dy: 3, shear_x: 0, shear_y: 0, columns: 2, rows: 2 }
const table = 'instance,entry,seed,length\na,mine,1,5\n'

const TRIANGLE =
  'TYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 1 0\n3 0 1\nEOF\n'

/** Valid arguments of everything that takes any, as `Class.method` or `function`; what is left out takes none. */
function valid(): Record<string, unknown[]> {
  const { spec: on, cells } = sessionOf(9, 9, new Uint8Array(81)).scenario
  const [heights, factors] = [null, null]
  return {
    'Run.constructor': [on, cells, heights, factors, 'ant-system', { ants: 4, iterations: 6 }, 7],
    'Run.advance': ['iteration', 1],
    'Run.change_walls': [{ blocked: [[4, 4]], freed: [] }],
    'Run.history': [0],
    'Run.keep_snapshots': [1 << 20],
    'Run.layer': ['trail'],
    'Run.level_at': [1, 1],
    'Run.moment': ['trail'],
    'Run.moves_from': [1, 1, 0],
    'Run.paint': [{}, 'trail', 'light', true, null],
    'Run.show_iteration': [1, 10],
    'Run.show_walls': [{ blocked: [[4, 5]], freed: [] }],
    'Comparison.constructor': [DOCUMENT],
    'Comparison.analysis': ['ant-moves', false],
    'Comparison.check': [ROW],
    'Comparison.dealt': ['1/2'],
    'Comparison.file': ['csv', 'by hand', 'en', { measures: ['length', 'turns'] }],
    'Comparison.fronts': [{ measures: ['length', 'turns'] }],
    'Comparison.forget': [0],
    'Comparison.journal': ['1/2'],
    'Comparison.journal_name': ['1/2'],
    'Comparison.keep': [ROW, [0.5, 1]],
    'Comparison.run': [0, () => 1],
    'Comparison.seed_by_seed': [1],
    'Comparison.take_journal': ['{}'],
    'OrderRun.constructor': [text(TRIANGLE), false, { ants: 3, iterations: 5 }, 7],
    'OrderRun.advance': [1],
    'DriveRun.constructor': [on, cells, heights, factors, 'd-star-lite', {}, 7, { hold: 2 }],
    'DriveRun.step': [1],
    'HandPath.constructor': [on, cells, heights, factors],
    'HandPath.measure': [
      [
        [0, 0],
        [1, 1],
      ],
    ],
    'HandPath.towards': [0, 0, 3, 2],
    'LookAhead.ant': [0],
    'LookAhead.go_to': [2],
    'ContourLines.constructor': [3, new Float32Array([1, 2, 3, 2, 3, 4, 3, 4, 9]), 1],
    ablation: ['fire', null, {}],
    check_scenario: [on, cells, heights, factors],
    export_geotiff: [on, cells, heights, factors],
    export_ros: [on, cells, 'x.pgm'],
    export_map: [on, cells, heights, factors, 'scenario'],
    figure_map: [new Uint8Array(6), 3, 'x'],
    find_figure: [gridOf(6)],
    felt_map: [on, cells, heights, factors],
    fitting_slices: [on, cells, heights, factors, 1],
    generate: ['random', 9, 9, 1, 0.2],
    import_map: [text('0 0\n0 0\n'), 'x', {}, null],
    import_scen: [text('version 1\n0 x.map 9 9 0 0 8 8 11.3\n')],
    import_terrain: [text(terrain), 'x.asc', null, null],
    join_results: [DOCUMENT, text(table), 'x.csv', null, []],
    map_colors: ['trail', 'light'],
    journal_digest: [text('{}')],
    list_matrices: [text('0 0\n0 0\n')],
    match_results: [DOCUMENT, text(table), 'x.csv'],
    paint_map: [{}, on, cells, heights, factors, 'dark', false],
    path_formats: [on],
    read_order: [text(TRIANGLE), false, null],
    read_path: [on, text('0,0\n1,1\n')],
    recognise: [text('0 0'), 'x'],
    read_figure: [pixel, lattice],
    reference: [on, cells, heights, factors, 'length'],
    results_template: [DOCUMENT],
    ros_image: [text('image: x.pgm\nresolution: 1\norigin: [0, 0, 0]\n')],
    show_picture: [pixel, 9],
    survey_terrain: [text(terrain), 'x.asc'],
    unpack: [gzipSync('0 0'), 'x.gz'],
    weight_colors: ['light'],
    write_path: [on, cells, heights, factors, straight(9), null, 'length', 'path-csv'],
  }
}

/** The diagonal of a map of so many cells a side. */
const straight = (side: number) => Array.from({ length: side }, (_, i) => [i, i])

/** A picture of a grid of so many cells a side, every other one a wall. */
function gridOf(side: number): Uint8Array {
  const pixels = Array.from({ length: (10 * side) ** 2 }, (_, at) => {
    const [x, y] = [at % (10 * side), Math.floor(at / (10 * side))]
    if (x % 10 === 0 || y % 10 === 0) return 90
    return (Math.floor(x / 10) + Math.floor(y / 10)) % 2 ? 0 : 255
  })
  return text(`P2\n${10 * side} ${10 * side}\n255\n${pixels.join(' ')}\n`)
}

let DOCUMENT = ''
let ROW = ''

/** Everything that the types of a build tell of: name, and how many parameters it has. */
function told(build: string): Map<string, number> {
  const types = readFileSync(join(PKG, build, 'formicarium.d.ts'), 'utf8')
  const own = types.split('export type InitInput')[0] ?? ''
  const found = new Map<string, number>()
  let inside = ''
  for (const line of own.split('\n')) {
    inside = /^export class (\w+)/.exec(line)?.[1] ?? (line === '}' ? '' : inside)
    const method = inside && /^ {4}(?:static )?(\w+)\((.*)\)(?::|;)/.exec(line)
    const free = /^export function (\w+)\((.*)\):/.exec(line)
    const [, name = '', parameters = ''] = method || free || []
    if (name === '' || name === 'free') continue
    found.set(method ? `${inside}.${name}` : name, parameters.match(/\w+\??: /g)?.length ?? 0)
  }
  return found
}

const cyclic: Record<string, unknown> = {}
cyclic.self = cyclic
/** So deep that nothing can go through it and come back. */
let deep: object = {}
for (let i = 0; i < 100_000; i++) deep = { deep }
const throws = () => {
  throw new Error('a getter of the script')
}

/** Of every kind, also what looks like another: prototypes are easily borrowed. */
const WRONG: [string, unknown][] = [
  ['undefined', undefined],
  ['null', null],
  ['NaN', Number.NaN],
  ['infinity', Number.POSITIVE_INFINITY],
  ['-1', -1],
  ['half', 0.5],
  ['2 to the 32', 2 ** 32],
  ['2 to the 53', 2 ** 53],
  ['1e300', 1e300],
  ['a large number', 4_000_000_000],
  ['bigint', 7n],
  ['true', true],
  ['empty text', ''],
  ['text', 'nonsense'],
  ['digits', '12'],
  ['half a pair', '\ud800'],
  ['zero', '\0'],
  ['long text', 'x'.repeat(100_000)],
  ['symbol', Symbol('s')],
  ['function', () => 1],
  ['object', {}],
  ['cyclic', cyclic],
  ['deep', deep],
  ['with a throwing getter', Object.defineProperty({}, 'ants', { get: throws, enumerable: true })],
  ['proxy', new Proxy({}, { ownKeys: throws, get: throws, has: throws })],
  ['no prototype', Object.create(null)],
  ['list', []],
  ['list of texts', ['a', 'b']],
  ['list of numbers', [1, 2, 3]],
  ['list of wild numbers', [256, -1, Number.NaN]],
  ['list with holes', new Array(7)],
  ['long list with holes', Object.assign([], { length: 4_000_000_000 })],
  ['frozen', Object.freeze([1])],
  ['bytes', new Uint8Array(3)],
  ['clamped', new Uint8ClampedArray(81)],
  ['integers', new Int32Array(81)],
  ['singles', new Float32Array(2)],
  ['doubles', new Float64Array(2)],
  ['buffer', new ArrayBuffer(81)],
  ['view', new DataView(new ArrayBuffer(81))],
  ['like bytes', Object.create(Uint8Array.prototype)],
  ['like singles', Object.create(Float32Array.prototype)],
  ['like doubles', Object.create(Float64Array.prototype)],
  ['like a list', Object.create(Array.prototype)],
  ['with a length', { length: 81, 0: 1 }],
  ['date', new Date(0)],
  ['map', new Map([['a', 1]])],
  ['set', new Set([1])],
  ['promise', Promise.resolve(1)],
  ['error', new Error('x')],
  ['regular expression', /x/],
  ['number object', new Number(3)],
  ['text object', new String('x')],
]

/** Refused by name, with all that an EngineError has. */
function isTyped(thrown: unknown): boolean {
  const error = thrown as Record<string, unknown>
  const words = ['kind', 'field', 'message', 'hint'].every(
    (key) => typeof error?.[key] === 'string',
  )
  return words && !(thrown instanceof Error) && typeof error.args === 'object'
}

/** How a call ends where it should not; null where it answers, or refuses as it should. */
function fault(call: () => unknown): string | null {
  try {
    const answer = call() as { free?: () => void } | null | undefined
    answer?.free?.()
    return null
  } catch (thrown) {
    return isTyped(thrown) ? null : String(thrown)
  }
}

function isTypedRefusal(call: () => unknown): boolean {
  try {
    call()
    return false
  } catch (thrown) {
    return isTyped(thrown)
  }
}

type RunArguments = ConstructorParameters<Engine['Run']>
const runArguments = () => valid()['Run.constructor'] as RunArguments

function golden(engine: Engine): string {
  const [on, cells, heights, factors, planner, params, seed] = runArguments()
  const run = new engine.Run(on, cells, heights, factors, planner, params, seed)
  run.advance('iteration', 6)
  const { digest } = run.summary()
  run.free()
  return digest
}

for (const build of ['', 'core']) {
  const name = build || 'whole'

  test(`the table of arguments is complete: ${name}`, async () => {
    prepare(await instance('', 'documents'))
    const table = valid()
    const functions = told(build)
    expect(functions.size).toBeGreaterThan(20)
    for (const [key, count] of functions) {
      expect(table[key]?.length ?? 0, key).toBe(count)
    }
  })

  test(`every wrong value at every parameter is refused by name: ${name}`, async () => {
    test.setTimeout(240_000)
    const engine = await instance(build, 'wrong')
    prepare(await instance('', 'documents'))
    const table = valid()
    const before = golden(engine)
    const faults: string[] = []
    const classes = engine as unknown as Record<
      string,
      new (
        ...args: unknown[]
      ) => Record<string, Call>
    >
    const kept: Record<string, Record<string, Call>> = {}
    const made = (name: string): Record<string, Call> => {
      // A look ahead is made by a run.
      if (name === 'LookAhead') kept[name] ??= made('Run').look_ahead?.() as Record<string, Call>
      kept[name] ??= new (
        classes[name] as never as new (
          ...args: unknown[]
        ) => Record<string, Call>
      )(...(table[`${name}.constructor`] ?? []))
      return kept[name]
    }
    const others: [string, unknown][] = [
      ['another class', made('Run')],
      ['itself', engine],
    ]
    for (const key of told(build).keys()) {
      const right = table[key] ?? []
      const [owner = '', method] = key.split('.')
      const call = (args: unknown[]) => {
        if (method === 'constructor')
          return new (classes[owner] as never as new (...a: unknown[]) => unknown)(...args)
        if (method) return made(owner)[method]?.(...args)
        return (engine as unknown as Record<string, Call>)[owner]?.(...args)
      }
      // What is right answers, but for pictures: node has no canvas.
      if (!key.includes('paint'))
        expect(
          fault(() => call(right)),
          key,
        ).toBeNull()
      for (const [what, wrong] of [...WRONG, ...others])
        for (let at = 0; at < right.length; at++) {
          const found = fault(() => call(right.map((each, i) => (i === at ? wrong : each))))
          if (found) faults.push(`${key}, parameter ${at}, ${what}: ${found}`)
        }
      const orders = [[...right].reverse(), [...right.slice(1), right[0]], [], [...right, ...right]]
      for (const args of orders.slice(0, right.length > 0 ? 4 : 0)) {
        const found = fault(() => call(args))
        if (found) faults.push(`${key}(${args.length}): ${found}`)
      }
    }
    expect(faults).toEqual([])
    for (const one of Object.values(kept)) one.status?.()
    expect(golden(engine)).toBe(before)
  })

  test(`numbers and words are not bent to fit: ${name}`, async () => {
    const engine = await instance(build, 'bent')
    const [on, cells, , , planner, params] = runArguments()
    const run = new engine.Run(on, cells, null, null, planner, params, 7)
    const call = run as unknown as Record<string, Call>
    const refused = (made: () => unknown) => {
      try {
        made()
      } catch (thrown) {
        const { kind, field } = thrown as { kind: string; field: string }
        return `${kind} ${field}`
      }
      return 'taken'
    }
    for (const seed of [-1, 2 ** 32, 0.5, '7', null, Number.NaN])
      expect(
        refused(() => new engine.Run(on, cells, null, null, planner, params, seed as never)),
      ).toBe('bad-argument seed')
    for (const wrong of [7, '0', {}, new Float32Array(81), [256]])
      expect(
        refused(() => new engine.Run(on, wrong as never, null, null, planner, params, 7)),
      ).toBe('bad-argument cells')
    expect(refused(() => call.advance?.('iteration', '3'))).toBe('bad-argument count')
    expect(refused(() => call.advance?.('iterations', 3))).toBe('bad-argument by')
    expect(refused(() => call.layer?.('smell'))).toBe('bad-argument kind')
    expect(refused(() => call.show_iteration?.('1', 1))).toBe('bad-argument iteration')
    // A list of numbers is as good as an array of bytes.
    const same = new engine.Run(on, [...(cells as Uint8Array)], null, null, planner, params, 7)
    same.advance('iteration', 2)
    run.advance('iteration', 2)
    expect(same.summary().digest).toBe(run.summary().digest)
  })

  test(`getters that throw, clocks that call back and freed objects leave the instance usable: ${name}`, async () => {
    const engine = await instance(build, 'freed')
    prepare(await instance('', 'documents'))
    const before = golden(engine)
    const [on, cells, , , planner, params] = runArguments()
    const run = new engine.Run(on, cells, null, null, planner, params, 7)
    const hostile = {
      ...(on as object),
      get width() {
        return throws()
      },
    }
    for (let i = 0; i < 2000; i++)
      expect(
        isTypedRefusal(
          () => new engine.Run(hostile as never, cells, null, null, planner, params, 7),
        ),
      ).toBe(true)
    const trap = Object.defineProperty({}, 'Iteration', { get: throws, enumerable: true })
    expect(() => run.advance(trap as never, 1)).toThrow(
      expect.objectContaining({ kind: 'bad-argument' }),
    )
    expect(run.advance('iteration', 1)).toBe('running')
    if (build === '') {
      const comparison = new engine.Comparison(DOCUMENT)
      const back = () => {
        comparison.keep(ROW, [1])
        return 1
      }
      expect(comparison.run(0, back).found).toBe(true)
      comparison.keep(ROW, [1, 2])
      expect(comparison.rows()).toContain(ROW)
    }
    run.free()
    expect(() => run.status()).toThrow(/null pointer/)
    for (let i = 0; i < 20_000; i++) fault(() => run.status())
    expect(golden(engine)).toBe(before)
  })
}

/** A small comparison, and the row of its first run. */
function prepare(whole: Engine): void {
  if (DOCUMENT !== '') return
  DOCUMENT = readFileSync(STUDY, 'utf8')
  const comparison = new whole.Comparison(DOCUMENT)
  ROW = comparison.run(0, () => 1).row
  comparison.free()
}
