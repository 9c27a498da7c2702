import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { ComparisonPage, documentText, holdRunsAfter, letRuns } from './comparison_page'
import { RacePage } from './race_page'
import { ResultsPage } from './results_page'
import { countCalls, ticks } from './workers'

const COLONIES = [
  { id: 'ants', planner: 'ant-system', set: { iterations: 12, ants: 6 } },
  { id: 'limits', planner: 'max-min-ant-system', set: { iterations: 12, ants: 6 } },
  { id: 'exact', planner: 'astar' },
]

test.describe('a comparison', () => {
  test('of what races runs to its end, is kept, and outlives a reload', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.openFromRace()
    await expect(comparison.entries).toHaveCount(2)
    await comparison.seeds(4)
    await expect(page.getByTestId('run-count')).toHaveText(/1 map × 2 planners × 4 seeds = 8 runs/)
    await comparison.run()
    await comparison.finished()
    await expect(comparison.runWords).toContainText('All 8 runs are done')
    const written = await page.evaluate(() => window.formicarium.resultFile('csv'))
    expect(written.trim().split('\n')).toHaveLength(1 + 8)
    await expect.poll(() => comparison.keptRuns()).toBe(8)

    await page.reload()
    await comparison.finished()
    await expect(comparison.runWords).toContainText('All 8 runs are done')
    expect(await page.evaluate(() => window.formicarium.resultFile('csv'))).toBe(written)
    await page.getByTestId('lab-back').click()
    await expect(page.getByTestId('kept-item')).toHaveCount(1)
    await expect(page.getByTestId('kept-item')).toContainText('Ant System – A* on Two corridors')
  })

  test('pauses, goes on, is stopped, removed, and brought back', async ({ page }) => {
    await holdRunsAfter(page, 20)
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ant-system', 'ship')
    // More than are let through and under way together, on as many processors as are made use of.
    const runs = 2 * 150
    await comparison.seeds(runs / 2)
    await comparison.run()
    await expect.poll(() => comparison.done()).toBeGreaterThan(4)
    await page.getByTestId('lab-pause').click()
    await expect(comparison.runWords).toContainText('finishing')
    await letRuns(page)
    await expect(comparison.runWords).toContainText('paused')
    const done = await comparison.done()
    expect(done).toBeLessThan(runs)
    await page.waitForTimeout(700)
    expect(await comparison.done()).toBe(done)
    expect(await page.evaluate(() => window.formicarium.resultFile('csv'))).toMatch(
      new RegExp(`^(.*\n){${done + 1}}$`),
    )

    await letRuns(page, 20)
    await page.getByTestId('lab-go-on').click()
    await expect.poll(() => comparison.done()).toBeGreaterThan(done)
    await page.getByTestId('lab-cancel').click()
    await expect(page.getByTestId('builder')).toBeVisible()
    const item = page.getByTestId('kept-item')
    await expect(item).toContainText('Interrupted')
    await item.getByTestId('kept-remove').click()
    await expect(item).toHaveCount(0)
    await page.getByRole('button', { name: 'Undo' }).click()
    await expect(item).toHaveCount(1)
    await letRuns(page)
    await item.getByTestId('kept-go-on').click()
    await comparison.finished()
    expect(await comparison.done()).toBe(runs)
  })

  test('counts runs without a path, and says so', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.on('unreachable')
    await comparison.compare('ant-system', 'astar')
    await comparison.set(1, 'iterations', 3)
    await comparison.seeds(3)
    await comparison.run()
    await comparison.finished()
    await expect(comparison.runWords).toContainText('6 found no path')
  })

  test('repeats a run whose worker has stopped, and reports one that stops it twice', async ({
    page,
  }) => {
    await page.addInitScript(stopWorkers, { once: [3], always: [5] })
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const result = await comparison.script({
      document: documentText({ entries: COLONIES.slice(0, 1), seeds: 12 }),
      workers: 2,
    })
    expect([result.runs, result.failed]).toEqual([11, 1])
    await expect(page.getByTestId('lab-failures')).toContainText('ants · 6')
    await expect(page.getByTestId('lab')).toHaveAttribute('data-phase', 'paused')
    // What crashed the worker is gone: the last run is done as well.
    await page.evaluate(() => {
      ;(window as unknown as { stopped: number[] }).stopped = []
    })
    await page.getByTestId('lab-go-on').click()
    await comparison.finished()
    expect(await comparison.done()).toBe(12)
    await expect(page.getByTestId('lab-failures')).toBeHidden()
  })

  test('runs all the same where the browser keeps nothing', async ({ page }) => {
    await page.addInitScript(() => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('not here', 'SecurityError')
      }
    })
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await expect(page.getByTestId('kept')).toContainText('keeps nothing')
    await comparison.seeds(3)
    await comparison.run()
    // Said once, and not again once it has been read.
    const warning = page.getByTestId('toast-warning')
    await expect(warning).toContainText('does not keep the runs')
    await warning.getByRole('button', { name: 'Dismiss' }).click()
    await comparison.finished()
    await expect(warning).toHaveCount(0)
  })

  test('is run by one tab at a time', async ({ page, context }) => {
    await holdRunsAfter(page, 20)
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ant-system', 'elitist-ant-system')
    await comparison.seeds(150)
    await comparison.run()
    await expect.poll(() => comparison.keptRuns()).toBeGreaterThan(2)

    const other = new ComparisonPage(await context.newPage())
    await other.open()
    await other.page.getByTestId('kept-item').getByTestId('kept-open').first().click()
    await expect(other.page.getByTestId('lab-elsewhere')).toBeVisible()
    await expect(other.page.getByTestId('lab-go-on')).toBeDisabled()
    await page.getByTestId('lab-pause').click()
    await letRuns(page)
    await expect(other.page.getByTestId('lab-elsewhere')).toBeHidden()
    const done = await comparison.done()
    expect(done).toBeGreaterThan(0)
    await expect.poll(() => other.done()).toBe(done)
    await expect(other.page.getByTestId('lab-go-on')).toBeEnabled()
  })
})

test.describe('result files', () => {
  const asked = documentText({ entries: COLONIES, seeds: 6 })

  test('have the same bytes whoever did the runs: one worker or four', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const one = await comparison.script({ document: asked, workers: 1 })
    const four = await comparison.script({ document: asked, workers: 4 })
    expect(one.files).toEqual(four.files)
    expect(one.runs).toBe(18)
    expect(JSON.parse(one.files.json).rows).toHaveLength(18)
  })

  test('have the same bytes as those of the command line', async ({ page }) => {
    const cli = process.env.FORMICARIUM_CLI
    test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { files } = await comparison.script({
      document: asked,
      command: 'formicarium compare small.json --out DIR',
    })
    const folder = mkdtempSync(join(tmpdir(), 'formicarium-lab-'))
    writeFileSync(join(folder, 'small.json'), files.json)
    execFileSync(cli ?? '', ['compare', 'small.json', '--out', 'again'], { cwd: folder })
    const again = (name: string) => readFileSync(join(folder, 'again', name), 'utf8')
    expect(again('small.csv')).toBe(files.csv)
    expect(again('small.md')).toBe(files.markdown)
    expect(again('small.tests.md')).toBe(files.tests)
    expect(again('small.json')).toBe(files.json)
  })
})

test('the race rests while one compares, and goes on afterwards', async ({ page }) => {
  await countCalls(page)
  const race = new RacePage(page)
  await race.open()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  await page.getByTestId('view-lab').click()
  await expect(page.getByTestId('play')).toBeHidden()
  const held = await ticks(page)
  await page.keyboard.press('Space')
  await page.waitForTimeout(500)
  expect(await ticks(page)).toBe(held)
  await expect(page).toHaveURL(/#lab$/)
  await page.reload()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.getByTestId('view-race').click()
  await expect(page.getByTestId('play')).toBeVisible()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  await expect.poll(() => new URL(page.url()).hash).toBe('')
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious in the laboratory (${scheme})`, async ({ page }) => {
    test.slow()
    await page.emulateMedia({ colorScheme: scheme })
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.entry(1).locator('summary').click()
    await expect(comparison.entry(1).getByTestId('param-ants')).toBeVisible()
    await page.getByTestId('budget-axis').selectOption('iterations')
    await expectClean(page, 'making a comparison')
    await comparison.seeds(2)
    await comparison.run()
    await comparison.finished()
    await new ResultsPage(page).told()
    await page.getByTestId('asked').locator('summary').click()
    await expect(page.getByTestId('asked').locator('.asked-lists')).toBeVisible()
    await expectClean(page, 'a comparison that is done')
    await page.getByTestId('lab-back').click()
    await expect(page.getByTestId('kept-item')).toHaveCount(1)
    await expectClean(page, 'with an earlier comparison')
  })
}

test('everything fits on a phone, and axe finds nothing serious @phone', async ({ page }) => {
  test.slow()
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await expectClean(page, 'making a comparison')
  expect(await overflow(page)).toBeLessThanOrEqual(0)
  await comparison.seeds(2)
  await comparison.run()
  await comparison.finished()
  await new ResultsPage(page).told()
  await expectClean(page, 'done')
  expect(await overflow(page)).toBeLessThanOrEqual(0)
})

test('the laboratory speaks Chinese', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.menu('language', 'language-zh-CN')
  await expect(comparison.start).toContainText(/\p{Script=Han}/u)
  await page.reload()
  await comparison.ready()
  await expect(comparison.start).toContainText(/\p{Script=Han}/u)
  await comparison.seeds(2)
  await comparison.run()
  await comparison.finished()
  await expect(comparison.runWords).toContainText(/\p{Script=Han}/u)
})

/** How much wider the page is than the screen. */
const overflow = (page: Page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)

/** Makes workers crash at some runs: the first time, or whenever `window.stopped` names them. */
function stopWorkers({ once, always }: { once: number[]; always: number[] }): void {
  const remembered = window as unknown as { stopped: number[] }
  remembered.stopped = always
  const first = new Set(once)
  /** Runs that a worker has yet to answer, and what makes it crash after them. */
  const owed = new WeakMap<Worker, (number | 'stop')[]>()
  const stopIfDue = (worker: Worker) => {
    if (owed.get(worker)?.[0] === 'stop')
      worker.dispatchEvent(new ErrorEvent('error', { message: 'stopped' }))
  }
  const post = Worker.prototype.postMessage
  Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
    const { call, id = 0, args } = message as { call?: string; id?: number; args?: number[] }
    const index = args?.[0] ?? -1
    if (call !== 'run') return Reflect.apply(post, this, [message, ...rest])
    const stops = first.delete(index) || remembered.stopped.includes(index)
    if (!owed.has(this))
      this.addEventListener('message', ({ data }) => {
        owed.set(this, owed.get(this)?.filter((each) => each !== data.id) ?? [])
        // Once the page has taken the answer.
        setTimeout(() => stopIfDue(this))
      })
    owed.set(this, [...(owed.get(this) ?? []), stops ? 'stop' : id])
    if (!stops) return Reflect.apply(post, this, [message, ...rest])
    setTimeout(() => stopIfDue(this))
  }
}
