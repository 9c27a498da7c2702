/** Where browsers give the page none of its parts, from a file or in a sandbox, it leads to the page in one file. */
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { expect, test } from '@playwright/test'
import { Course, ParentPage } from './parent_page'
import { RacePage } from './race_page'
import { offline } from './saved_pages'
import { DIST } from './static_host'

const PAGE = pathToFileURL(join(DIST, 'index.html')).href

const SANDBOX = 'sandbox="allow-scripts" referrerpolicy="origin"'

test('opened as a file, with its link', async ({ page, browser }) => {
  await new RacePage(page).openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  const link = await new RacePage(page).shareLink()
  const { page: other, complaints } = await offline(browser)
  await other.goto(PAGE + link.slice(link.indexOf('#')))
  await expect(other).toHaveURL(/one-file\.html#x=/)
  await expect(other.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
  expect(complaints).toEqual([])
})

test.describe('in a sandbox of another page', () => {
  let course: Course
  test.beforeEach(async () => {
    course = await Course.open()
  })
  test.afterEach(() => course.close())

  test('the page runs, and says that nothing is kept', async ({ page }) => {
    const { inner } = await ParentPage.around(page, course, '', SANDBOX)
    await expect(inner.getByTestId('play')).toBeVisible({ timeout: 30_000 })
    await inner.getByTestId('share').click()
    await expect(inner.getByTestId('share-dialog')).toBeVisible()
  })

  test('a frame answers messages, runs and compares', async ({ page }) => {
    const parent = await ParentPage.around(page, course, '?embed', SANDBOX)
    await expect(parent.inner.getByTestId('play')).toBeVisible({ timeout: 30_000 })
    const ready = () =>
      page.evaluate(() =>
        (window as unknown as { heard: { origin: string; data: { event?: string } }[] }).heard.some(
          ({ data }) => data.event === 'ready',
        ),
      )
    await expect.poll(ready).toBe(true)
    const answer = await page.evaluate(
      () =>
        new Promise((resolve) => {
          addEventListener('message', ({ data }) => {
            if (data.id === 1) resolve(data)
          })
          const target = document.querySelector('iframe')?.contentWindow
          target?.postMessage(
            { formicarium: 1, kind: 'run', id: 1, options: { iterations: 3 } },
            '*',
          )
        }),
    )
    expect(answer).toMatchObject({ kind: 'answer', value: [{ summary: { iteration: 3 } }, {}] })
    const compared = await page.evaluate(
      () =>
        new Promise((resolve) => {
          addEventListener('message', ({ data }) => {
            if (data.id === 2) resolve(data)
          })
          const options = { planners: ['ant-system'], seeds: 2 }
          const target = document.querySelector('iframe')?.contentWindow
          target?.postMessage({ formicarium: 1, kind: 'compare', id: 2, options }, '*')
        }),
    )
    expect(compared).toMatchObject({ kind: 'answer', value: { runs: 2, failed: 0 } })
  })
})
