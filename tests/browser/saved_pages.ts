/** Pages of one file: saved by the page under test, and opened from a folder without any network. */
import { mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { type Browser, expect, type Page, test } from '@playwright/test'

/** Saves what a dialog that is open shares; the address of the file. */
export async function savedPage(page: Page, testId: string, name: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(testId).click(),
  ])
  expect(download.suggestedFilename()).toMatch(/\.html$/)
  const folder = test.info().outputPath('pages')
  mkdirSync(folder, { recursive: true })
  const file = join(folder, name)
  await download.saveAs(file)
  return pathToFileURL(file).href
}

/** A page in a browser of its own that reaches nothing: every request fails, and is noted, as is what breaks the page's policy. */
export async function offline(browser: Browser): Promise<{ page: Page; complaints: string[] }> {
  const context = await browser.newContext({ offline: true, acceptDownloads: true })
  const complaints: string[] = []
  await context.route(/^(?!file:|data:|blob:)/, (route) => {
    complaints.push(route.request().url())
    return route.abort()
  })
  const page = await context.newPage()
  page.on('pageerror', (error) => complaints.push(`${error}`))
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text())
  })
  return { page, complaints }
}
