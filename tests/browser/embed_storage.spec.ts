/** A frame in which the browser keeps nothing: the page runs and compares all the same, and says so once. */
import { expect, type Page, test } from '@playwright/test'
import { documentText } from './comparison_page'
import { Course, home, ParentPage } from './parent_page'

let course: Course

test.beforeAll(async () => {
  course = await Course.open()
})
test.afterAll(() => course.close())

/** As in a sandbox without an origin: everything that keeps something refuses it. Only our page is so treated. */
async function refuseStorage(page: Page): Promise<void> {
  await page.addInitScript((ours) => {
    if (location.origin !== ours) return
    const refuse = () => {
      throw new DOMException('The operation is insecure.', 'SecurityError')
    }
    for (const name of ['localStorage', 'sessionStorage', 'caches'])
      Object.defineProperty(window, name, { get: refuse })
    IDBFactory.prototype.open = refuse
    LockManager.prototype.request = () => Promise.reject(new DOMException('no', 'SecurityError'))
    LockManager.prototype.query = () => Promise.reject(new DOMException('no', 'SecurityError'))
  }, new URL(home()).origin)
}

const DOCUMENT = documentText({
  entries: [
    { id: 'ants', planner: 'ant-system' },
    { id: 'search', planner: 'astar' },
  ],
  seeds: 30,
})

/** Runs and compares by what the page offers itself. */
async function runAndCompare(parent: ParentPage) {
  const frame = await parent.frame()
  await frame.waitForFunction(() => {
    const all = window.formicarium?.results()
    return all && all.length > 0 && all.every((one) => one.summary !== null)
  })
  const [before] = await frame.evaluate(() => window.formicarium.results())
  const [first] = await frame.evaluate(() => window.formicarium.run({ iterations: 3 }))
  expect(first?.summary?.iteration).toBe((before?.summary?.iteration ?? 0) + 3)
  const { runs, total, failed } = await frame.evaluate(
    (document) => window.formicarium.compare({ document }),
    DOCUMENT,
  )
  expect([runs, total, failed]).toEqual([60, 60, 0])
}

const SANDBOX = 'sandbox="allow-scripts allow-same-origin"'

for (const [what, query, attributes, said] of [
  ['an embedded page in a sandbox', '?embed', SANDBOX, 'nothing is kept'],
  ['the whole page in a sandbox', '', SANDBOX, 'keeps nothing of this page'],
] as const)
  test(`${what} that refuses storage and locks runs and compares`, async ({ page }) => {
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(error.message))
    await refuseStorage(page)
    const parent = await ParentPage.around(page, course, query, attributes)
    if (query === '') await expect(parent.inner.getByTestId('toast-info')).toContainText(said)
    await runAndCompare(parent)
    if (query !== '') await expect(parent.inner.getByTestId('toast-info')).toContainText(said)
    await expect(parent.inner.getByTestId('toast-error')).toHaveCount(0)
    expect(errors).toEqual([])
  })

test('it is said once: a second comparison runs without a word', async ({ page }) => {
  await refuseStorage(page)
  const parent = await ParentPage.around(page, course, '?embed', SANDBOX)
  await runAndCompare(parent)
  await parent.inner.getByTestId('toast-info').getByRole('button').click()
  await runAndCompare(parent)
  await expect(parent.inner.getByTestId('toast-info')).toHaveCount(0)
})

test('a real frame of another site runs, compares and leaves nothing behind', async ({ page }) => {
  const parent = await ParentPage.around(page, course, '?embed')
  await runAndCompare(parent)
  const frame = await parent.frame()
  const kept = await frame.evaluate(async () => {
    // Chromium may refuse frames of other sites all of it.
    try {
      const databases = await indexedDB.databases()
      return localStorage.length + sessionStorage.length + databases.length
    } catch {
      return 0
    }
  })
  expect(kept).toBe(0)
})

test('in a sandbox without an origin a download is not lost without a word', async ({ page }) => {
  // Files of scripts are refused there, so the whole page stands for it, told that it has no origin.
  await page.addInitScript((ours) => {
    if (location.origin === ours) Object.defineProperty(window, 'origin', { get: () => 'null' })
  }, new URL(home()).origin)
  const parent = await ParentPage.around(page, course, '', SANDBOX)
  await parent.inner.getByTestId('share').click()
  await expect(parent.inner.getByTestId('share-link')).toHaveValue(/#x=/)
  await parent.inner.getByTestId('share-file').click()
  await page.keyboard.press('Escape')
  const said = parent.inner.getByTestId('toast-warning')
  await expect(said).toContainText('may not allow downloads')
  await said.getByRole('button', { name: 'Copy the text' }).click()
  await expect(parent.inner.getByTestId('toast-success')).toBeVisible()
})
