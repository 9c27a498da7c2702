import { type BrowserContext, expect, test } from '@playwright/test'
import { documentText, Laboratory } from './lab_page'

const ASKED = documentText({
  entries: [
    { id: 'ants', planner: 'ant-system' },
    { id: 'ranks', planner: 'rank-based-ant-system' },
  ],
  seeds: 400,
  rows: Array.from({ length: 24 }, () => '.'.repeat(24)),
})

/** No machine does more than a hundred runs a second then with one worker, which has two of them in line: one can break it off. */
function holdRuns(): void {
  const post = Worker.prototype.postMessage
  Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
    const send = () => Reflect.apply(post, this, [message, ...rest])
    if ((message as { call?: string }).call === 'run') setTimeout(send, 20)
    else send()
  }
}

/** A tab whose comparison is under way. */
async function begun(context: BrowserContext): Promise<Laboratory> {
  const laboratory = new Laboratory(await context.newPage())
  await laboratory.page.addInitScript(holdRuns)
  await laboratory.open()
  // Nobody waits for its end.
  await laboratory.page.evaluate((document) => {
    void window.formicarium.compare({ document, workers: 1 }).catch(() => {})
  }, ASKED)
  await expect.poll(() => laboratory.done()).toBeGreaterThan(5)
  return laboratory
}

test('a tab closed at any moment loses nothing that was done, and what follows is the same', async ({
  browser,
}) => {
  const context = await browser.newContext()
  const first = await begun(context)
  // Some moment, another one at every start.
  await first.page.waitForTimeout(400 * Math.random())
  await first.page.close()

  const second = new Laboratory(await context.newPage())
  await second.open()
  const item = second.page.getByTestId('kept-item')
  await expect(item).toContainText('Interrupted')
  await item.getByTestId('kept-open').click()
  await expect.poll(() => second.phase()).toBe('paused')
  // It is opened once more if the first tab was still about to go.
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
  const laboratory = new Laboratory(page)
  await expect.poll(() => laboratory.phase()).toBe('paused')
  await expect.poll(() => laboratory.done()).toBeGreaterThan(0)
  expect(await laboratory.done()).toBeLessThan(800)
  await page.getByTestId('lab-go-on').click()
  await laboratory.finished()
  await expect.poll(() => laboratory.done()).toBe(800)
  await context.close()
})
