/** Page object of the results, and a document that gives each of their parts something to show. */
import { expect, type Locator, type Page } from '@playwright/test'
import { ComparisonPage } from './comparison_page'

export const SEEDS = 24
export const MAPS = ['small', 'wide'] as const
/** In the order of the question; the last two have imported results, and none. */
export const ENTRIES = ['weak', 'limits', 'exact', 'theirs', 'absent'] as const

/** Winding enough for a lone ant to get lost. */
const ROWS = {
  small: [
    '..........@...',
    '.@@@@.@@.@@@..',
    '.@....@......@',
    '.@.@@@@.@@@@.@',
    '...@..........',
    '@@.@.@@@@.@@.@',
    '...@....@..@..',
    '.@@@@@@.@@.@@.',
    '......@...@...',
    '.@@@@.@@@...@.',
    '....@.....@...',
  ],
  wide: [
    '................',
    '.@@.@@@@.@@.@@@.',
    '.@..@..@.@......',
    '...@@.@@...@@.@.',
    '.@......@.......',
    '.@.@@@@.@.@@@.@.',
    '.......@........',
  ],
}

/** An imported run, as the document keeps it. */
const given = (instance: number, seed: number, length: number) => ({
  task: { instance, entry: 3, seed },
  status: seed % 6 === 0 ? 'no-path' : 'budget-spent',
  found:
    seed % 6 === 0 ? null : { length, turns: null, turn_index: null, weight: null, value: length },
  effort: [null, null, null, null],
  trace: [],
  digest: '',
})

/** One ant that dies in the first dead end, twice. */
const LOST = { iterations: 2, ants: 1, beta: 2, heuristic: 'goal', dead_end: 'die' }

const planner = (id: string, planner: string, set: object, published?: object) => ({
  id,
  label: { weak: 'Weak ants', limits: 'Trail limits', exact: 'A*' }[id],
  role: id === 'weak' ? 'baseline' : 'improved',
  planner,
  set,
  ...(published && { published: { small: published } }),
})

/** Two maps, a published number, an impossible one, and a claim. */
export function richDocument(seeds = SEEDS): string {
  const maps = MAPS.map((name) => {
    const rows = ROWS[name]
    const [width, height] = [rows[0]?.length ?? 0, rows.length]
    return {
      format: 'formicarium/scenario@1',
      name: name === 'small' ? 'Small' : 'Wide',
      width,
      height,
      start: [0, 0],
      goals: [{ at: [width - 1, height - 1] }],
      map: { rows },
    }
  })
  return JSON.stringify({
    format: 'formicarium/comparison@1',
    question: {
      format: 'formicarium/question@1',
      title: 'Rich results',
      asks: '?',
      seeds: { from: 1, count: seeds },
      instances: MAPS.map((id) => ({ id, map: `${id}.json`, note: 'Drawn for a test.' })),
      entries: [
        planner('weak', 'ant-system', LOST, { length: 26, turns: 9 }),
        planner(
          'limits',
          'max-min-ant-system',
          { iterations: 10, ants: 6, beta: 2 },
          { length: 5 },
        ),
        planner('exact', 'astar', {}),
        { id: 'theirs', label: 'Theirs', role: 'other', results: 'theirs.csv' },
        { id: 'absent', label: 'Absent', role: 'other', missing: 'no formulas are published' },
      ],
      claims: [
        {
          id: 'shorter',
          says: 'shorter paths',
          improved: 'limits',
          baseline: 'weak',
          measure: 'length',
          direction: 'less',
        },
      ],
    },
    maps,
    given: MAPS.flatMap((_, instance) =>
      Array.from({ length: seeds }, (_, i) => given(instance, i + 1, 24 + ((i * 7) % 5))),
    ),
  })
}

/** One run of the CSV. */
export type CsvRow = Record<string, string>

export class ResultsPage {
  readonly comparison: ComparisonPage

  constructor(readonly page: Page) {
    this.comparison = new ComparisonPage(page)
  }

  /** Runs a comparison to its end, and waits for its complete analysis. */
  async show(document = richDocument()): Promise<void> {
    await this.comparison.open()
    await this.comparison.script({ document })
    await this.comparison.finished()
    await this.told()
  }

  /** Waits for the complete analysis of runs that are done, intervals included. */
  async told(): Promise<void> {
    await this.tab('summary')
    const table = this.page.getByTestId('summary-table')
    await expect(table).toBeVisible()
    await expect(table).not.toContainText('planned')
    await expect(table).not.toContainText('…')
  }

  async tab(
    id: 'matrix' | 'summary' | 'figures' | 'fronts' | 'tests' | 'reported' | 'files',
  ): Promise<void> {
    await this.page.getByTestId(`results-tab-${id}`).click()
    await expect(this.page.getByTestId(`results-tab-${id}`)).toHaveAttribute(
      'aria-selected',
      'true',
    )
  }

  async figures(): Promise<void> {
    await this.tab('figures')
    await expect(this.picture('values')).toBeVisible()
  }

  figure(id: string): Locator {
    return this.page.getByTestId(`figure-${id}`)
  }

  /** As it is drawn on the page. */
  picture(id: string): Locator {
    return this.figure(id).locator('.figure-picture > svg')
  }

  async axis(id: 'iterations' | 'constructed-paths' | 'moves' | 'time'): Promise<void> {
    await this.page.getByTestId(`axis-${id}`).click()
  }

  /** The file that a button downloads. */
  async downloaded(testId: string): Promise<{ name: string; bytes: Buffer }> {
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.getByTestId(testId).click(),
    ])
    const chunks: Buffer[] = []
    for await (const chunk of await download.createReadStream()) chunks.push(Buffer.from(chunk))
    return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) }
  }

  file(kind: string): Promise<string> {
    return this.page.evaluate((wanted) => window.formicarium.resultFile(wanted as 'csv'), kind)
  }

  /** The runs as the CSV has them: what every table and figure is about. */
  async rows(instance: string, entry: string): Promise<CsvRow[]> {
    const [head, ...lines] = (await this.file('csv')).trim().split('\n')
    const names = head?.split(',') ?? []
    const all = lines.map((line) => {
      const fields = line.split(',')
      return Object.fromEntries(names.map((name, i) => [name, fields[i] ?? '']))
    })
    return all.filter((row) => row.instance === instance && row.entry === entry)
  }
}

/** Type 7, as R and NumPy have it. */
export function quantile(values: number[], p: number): number {
  const ascending = [...values].sort((a, b) => a - b)
  const place = p * (ascending.length - 1)
  const below = Math.floor(place)
  const [low, high] = [ascending[below] ?? 0, ascending[Math.ceil(place)] ?? 0]
  return low + (place - below) * (high - low)
}

export const lengths = (rows: CsvRow[]): number[] =>
  rows.filter(({ length }) => length !== '').map(({ length }) => Number(length))
