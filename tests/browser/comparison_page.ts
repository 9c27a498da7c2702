/** Page object of the laboratory, where comparisons are made. */
import { expect, type Locator, type Page } from '@playwright/test'
import type { CompareOptions, ComparisonResult } from '../../www/src/model/scripting'
import { RacePage } from './race_page'

export class ComparisonPage {
  constructor(readonly page: Page) {}

  /** Opens the page at the laboratory, once every planner is known. */
  async open(): Promise<void> {
    await this.page.goto('about:blank')
    await this.page.goto('./#lab')
    await this.ready()
  }

  async ready(): Promise<void> {
    await expect(this.page.getByTestId('builder')).toBeVisible()
    await expect(this.start).toBeEnabled()
  }

  /** Opens it from the race, as most readers do. */
  async openFromRace(): Promise<void> {
    await new RacePage(this.page).open()
    await this.page.getByTestId('view-lab').click()
    await this.ready()
  }

  get start(): Locator {
    return this.page.getByTestId('lab-start')
  }

  get entries(): Locator {
    return this.page.getByTestId(/^entry-\d+$/)
  }

  get maps(): Locator {
    return this.page.getByTestId('draft-map')
  }

  entry(place: number): Locator {
    return this.page.getByTestId(`entry-${place}`)
  }

  /** Exactly these planners, with their default parameters. */
  async compare(...planners: string[]): Promise<void> {
    for (let left = await this.entries.count(); left > 0; left--)
      await this.entry(left).getByTestId('entry-remove').click()
    for (const id of planners) await this.add(id)
    await expect(this.entries).toHaveCount(planners.length)
  }

  async add(planner: string): Promise<void> {
    await this.menu('lab-add-planner', `lab-add-${planner}`)
  }

  /** Exactly these built-in maps. */
  async on(...ids: string[]): Promise<void> {
    const remove = this.maps.getByRole('button')
    for (let left = await this.maps.count(); left > 0; left--) await remove.first().click()
    for (const [before, id] of ids.entries()) {
      await this.menu('lab-add-map', `add-map-${id}`)
      // Some are generated: the next one must not overtake it.
      await expect(this.maps).toHaveCount(before + 1)
    }
  }

  async seeds(count: number, from = 1): Promise<void> {
    await this.type('seed-count', count)
    await this.type('seed-from', from)
  }

  /** A parameter of an entry. */
  async set(place: number, key: string, value: string | number): Promise<void> {
    const values = this.entry(place).locator('details')
    if (!(await values.evaluate((one: HTMLDetailsElement) => one.open)))
      await values.locator('summary').click()
    await this.type(`param-${key}`, value, this.entry(place))
  }

  async type(field: string, value: string | number, within: Page | Locator = this.page) {
    await within.getByTestId(field).fill(String(value))
    await within.getByTestId(field).press('Enter')
  }

  async menu(menu: string, item: string): Promise<void> {
    await this.page.getByTestId(menu).click()
    await this.page.getByTestId(item).click()
  }

  async run(): Promise<void> {
    await this.start.click()
    await expect(this.page.getByTestId('run-bar')).toBeVisible()
  }

  phase(): Promise<string | null> {
    return this.page.getByTestId('lab').getAttribute('data-phase')
  }

  async finished(timeout = 60_000): Promise<void> {
    await expect(this.page.getByTestId('lab')).toHaveAttribute('data-phase', 'done', { timeout })
  }

  /** Runs that are done, by the bar. */
  async done(): Promise<number> {
    return Number(await this.page.getByTestId('lab-progress').getAttribute('aria-valuenow'))
  }

  async words(): Promise<string> {
    return (await this.runWords.textContent()) ?? ''
  }

  /** What the bar says of the runs. */
  get runWords(): Locator {
    return this.page.getByTestId('run-words')
  }

  /** How many runs the browser has stored, of all comparisons. A comparison must have begun. */
  keptRuns(): Promise<number> {
    return inStorage(this.page, 'rows', 'count')
  }

  /** Compares by the scripting interface, and gives the result files. */
  script(options: CompareOptions = {}): Promise<ComparisonResult> {
    return this.page.evaluate((given) => window.formicarium.compare(given), options)
  }
}

/** What the browser has stored for the laboratory: how much a store holds, or all of it. */
export function inStorage<T>(page: Page, store: 'rows' | 'drafts', what: 'count' | 'getAll') {
  return page.evaluate(
    async ([store, what]): Promise<T> => {
      const of = <T>(request: IDBRequest<T>) =>
        new Promise<T>((resolve, reject) => {
          request.onsuccess = () => resolve(request.result)
          request.onerror = () => reject(request.error)
        })
      const database = await of(indexedDB.open('formicarium.lab'))
      const asked: unknown = database.transaction(store).objectStore(store)[what]()
      const found = await of(asked as IDBRequest<T>)
      database.close()
      return found
    },
    [store, what] as const,
  )
}

declare global {
  interface Window {
    /** How many more runs may begin, and those that wait. */
    runs: { free: number; held: (() => void)[] }
  }
}

/**
 * From the page's next opening on, lets so many runs begin and holds back all others, so that however fast the machine is, a test finds
 * runs that are not done.
 */
export async function holdRunsAfter(page: Page, count: number): Promise<void> {
  await page.addInitScript((free) => {
    const runs = { free, held: [] as (() => void)[] }
    window.runs = runs
    const post = Worker.prototype.postMessage
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
      const go = () => Reflect.apply(post, this, [message, ...rest])
      if ((message as { call?: string }).call !== 'run') go()
      else if (runs.free > 0) {
        runs.free--
        go()
      } else runs.held.push(go)
    }
  }, count)
}

/** Lets so many runs more begin; all, if nothing is said. */
export async function letRuns(page: Page, count = Number.POSITIVE_INFINITY): Promise<void> {
  await page.evaluate((free) => {
    const begin = window.runs.held.splice(0, free)
    window.runs.free = free - begin.length
    for (const go of begin) go()
  }, count)
}

interface Asked {
  entries: { id: string; planner: string; set?: Record<string, number | string | boolean> }[]
  seeds: number
  rows?: string[]
}

const ROWS = ['.......@', '.@@@@..@', '.@......', '...@@@..', '.@......', '.@..@@@.', '........']

/** A document to be run: one small map, unless it has rows of its own. */
export function documentText({ entries, seeds, rows = ROWS }: Asked): string {
  const [width, height] = [rows[0]?.length ?? 0, rows.length]
  return JSON.stringify({
    format: 'formicarium/comparison@1',
    question: {
      format: 'formicarium/question@1',
      title: 'Small',
      asks: '?',
      seeds: { from: 1, count: seeds },
      instances: [{ id: 'small', map: 'small.json' }],
      entries: entries.map((entry) => ({ label: entry.id, role: 'other', ...entry })),
    },
    maps: [
      {
        format: 'formicarium/scenario@1',
        name: 'Small',
        width,
        height,
        start: [0, 0],
        goals: [{ at: [width - 1, height - 1] }],
        map: { rows },
      },
    ],
  })
}
