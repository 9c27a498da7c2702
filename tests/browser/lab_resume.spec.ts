import { type BrowserContext, expect, test } from '@playwright/test'
import { ComparisonPage, documentText } from './comparison_page'

const ASKED = documentText({
  entries: [
    { id: 'ants', planner: 'ant-system' },
    { id: 'ranks', planner: 'rank-based-ant-system' },
  ],
  seeds: 400,
  rows: Array.from({ length: 24 }, () => '.'.repeat(24)),
})

/** Slows runs down to a hundred a second, so that the comparison can be interrupted. */
function holdRuns(): void {
  const post = Worker.prototype.postMessage
  Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
    const send = () => Reflect.apply(post, this, [message, ...rest])
    if ((message as { call?: string }).call === 'run') setTimeout(send, 20)
    else send()
  }
}

/** A tab whose comparison is under way. */
async function begun(context: BrowserContext): Promise<ComparisonPage> {
  const comparison = new ComparisonPage(await context.newPage())
  await comparison.page.addInitScript(holdRuns)
  await comparison.open()
  // Its end is not waited for.
  await comparison.page.evaluate((document) => {
    void window.formicarium.compare({ document, workers: 1 }).catch(() => {})
  }, ASKED)
  await expect.poll(() => comparison.done()).toBeGreaterThan(5)
  return comparison
}

test('a tab closed at any moment loses nothing that was done, and what follows is the same', async ({
  browser,
}) => {
  const context = await browser.newContext()
  const first = await begun(context)
  // A moment that differs from test run to test run.
  await first.page.waitForTimeout(400 * Math.random())
  await first.page.close()

  const second = new ComparisonPage(await context.newPage())
  await second.open()
  const item = second.page.getByTestId('kept-item')
  await expect(item).toContainText('Interrupted')
  await item.getByTestId('kept-open').click()
  await expect.poll(() => second.phase()).toBe('paused')
  // Opened once more in case the first tab had not closed yet.
  let kept = 0
  const told = async () => {
    kept = await second.done()
    return (await second.words()).includes(`${kept} from before`)
  }
  await expect.poll(told).toBe(true)
  console.log(`${kept} of 800 runs were kept`)
  expect(kept).toBeGreaterThan(0)
  expect(kept).toBeLessThan(800)
  await second.page.getByTestId('lab-go-on').click()
  await second.finished()
  const resumed = await second.page.evaluate(() => window.formicarium.resultFile('json'))

  const unbroken = await second.script({ document: ASKED })
  expect(resumed).toBe(unbroken.files.json)
  await context.close()
})

test('a reload in the middle opens the same comparison, paused', async ({ browser }) => {
  const context = await browser.newContext()
  const { page } = await begun(context)
  await page.reload()
  const comparison = new ComparisonPage(page)
  await expect.poll(() => comparison.phase()).toBe('paused')
  await expect.poll(() => comparison.done()).toBeGreaterThan(0)
  expect(await comparison.done()).toBeLessThan(800)
  await page.getByTestId('lab-go-on').click()
  await comparison.finished()
  await expect.poll(() => comparison.done()).toBe(800)
  await context.close()
})
