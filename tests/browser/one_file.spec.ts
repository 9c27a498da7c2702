/** The page as one file (docs/one_file.md): saved, opened from a folder without a network, verified, edited and saved again. */
import { execFileSync } from 'node:child_process'
import { createReadStream, readFileSync, statSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import AxeBuilder from '@axe-core/playwright'
import { expect, type FrameLocator, type Page, test } from '@playwright/test'
import { ABOUT_MB } from '../../www/src/share/page_file'
import { ComparisonPage, documentText } from './comparison_page'
import { dropFiles } from './dropped_files'
import { RacePage } from './race_page'
import { offline, savedPage } from './saved_pages'

const TEMPLATE = join(__dirname, '../../www/dist/one-file.html')
const MOST_BYTES = 2_500_000
const DOCUMENT = documentText({
  entries: [
    { id: 'ants', planner: 'ant-system', set: { iterations: 10, ants: 5 } },
    { id: 'exact', planner: 'astar' },
  ],
  seeds: 3,
})

/** A race that has run a little, as a page. */
async function racePage(page: Page, name = 'race.html'): Promise<string> {
  await new RacePage(page).openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  return shared(page, name)
}

async function shared(page: Page, name: string): Promise<string> {
  await page.getByTestId('share').click()
  const address = await savedPage(page, 'share-page', name)
  await page.keyboard.press('Escape')
  return address
}

async function verified(page: Page | FrameLocator, ...places: number[]): Promise<void> {
  for (const place of places)
    await expect(page.getByTestId(`verified-${place}`)).toHaveAttribute('data-verified', 'verified')
}

/** Cells of the map on show. */
const cells = (page: Page) =>
  page.evaluate(() => window.formicarium.session()?.scenario.cells.join(''))

const ofFile = (address: string) => readFileSync(fileURLToPath(address), 'utf8')

/** What it carries aside, and what it is called. */
const bare = (page: string) =>
  page
    .replace(/<title>.*?<\/title>/s, '')
    .replace(/<script type="application\/json" id="carried".*?<\/script>/s, '')

test('is small enough to be sent, and as large as the page says', () => {
  const { size } = statSync(TEMPLATE)
  expect(size).toBeLessThanOrEqual(MOST_BYTES)
  expect(Math.abs(size / 1e6 - ABOUT_MB)).toBeLessThan(0.06)
})

test('a race opens without a network, verified, is edited, and saved again', async ({
  page,
  browser,
}) => {
  const address = await racePage(page)
  const hosted = await cells(page)
  const { page: first, complaints } = await offline(browser)
  await first.goto(address)
  await verified(first, 1, 2)
  expect(await cells(first)).toBe(hosted)
  await expect(first).toHaveTitle(/^Two corridors · Formicarium$/)

  const race = new RacePage(first)
  await first.getByTestId('reset').click()
  await race.drag([
    [4, 19],
    [9, 19],
  ])
  const edited = await cells(first)
  expect(edited).not.toBe(hosted)
  await first.evaluate(() => window.formicarium.run({ iterations: 4 }))
  const again = await shared(first, 'again.html')

  const { page: second } = await offline(browser)
  await second.goto(again)
  await verified(second, 1, 2)
  expect(await cells(second)).toBe(edited)
  // Not toBe: it would print two pages.
  expect(bare(ofFile(again)) === bare(ofFile(address))).toBe(true)
  expect(complaints).toEqual([])
})

test('a changed result is said to differ', async ({ page, browser }) => {
  const address = await racePage(page)
  const text = ofFile(address)
  const [, digest = ''] = /"digest": "([0-9a-f]{16})"/.exec(text) ?? []
  const spoilt = address.replace('race.html', 'spoilt.html')
  writeFileSync(fileURLToPath(spoilt), text.replace(digest, 'feedfacecafebeef'))
  const { page: other } = await offline(browser)
  await other.goto(spoilt)
  await expect(other.getByTestId('verified-1')).toHaveAttribute('data-verified', 'differs')
})

test('a comparison opens without a network with its tables, and is verified', async ({
  page,
  browser,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.script({ document: DOCUMENT })
  await comparison.finished()
  await page.getByTestId('lab-share').click()
  const address = await savedPage(page, 'lab-share-page', 'comparison.html')

  const { page: other, complaints } = await offline(browser)
  await other.goto(address)
  await expect(other.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
  await expect(other.locator('.result-table').first()).toContainText('gap 0.0%')
  await other.getByTestId('verify-again').click()
  await expect(other.getByTestId('verification')).toHaveAttribute('data-state', 'same')
  await other.getByTestId('lab-share').click()
  const again = await savedPage(other, 'lab-share-page', 'again.html')
  expect(ofFile(again) === ofFile(address)).toBe(true)
  // The address names what only this page had: after a reload it is there all the same.
  await other.keyboard.press('Escape')
  await other.reload()
  await expect(other.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
  await expect(other.getByTestId('toast-warning')).toHaveCount(0)
  expect(complaints).toEqual([])
})

test('dropped on a hosted page, it gives what it carries', async ({ page }) => {
  const address = await racePage(page)
  await page.getByTestId('seed').fill('77')
  await page.getByTestId('seed').press('Enter')
  await dropFiles(page, 'body', [['race.html', ofFile(address)]])
  await expect(page.getByTestId('seed')).toHaveValue('1')
  await verified(page, 1, 2)
})

test('a link in its address goes before what it carries', async ({ page, browser }) => {
  const address = await racePage(page)
  await page.getByTestId('seed').fill('77')
  await page.getByTestId('seed').press('Enter')
  const link = await new RacePage(page).shareLink()
  const { page: other } = await offline(browser)
  await other.goto(`${address}#${link.split('#')[1]}`)
  await expect(other.getByTestId('seed')).toHaveValue('77')
})

test('its links lead to the page that it was saved from', async ({ page, browser, baseURL }) => {
  const address = await racePage(page)
  const { page: other } = await offline(browser)
  await other.goto(address)
  await verified(other, 1)
  await other.getByTestId('share').click()
  await expect(other.getByTestId('share-link')).toHaveValue(new RegExp(`^${baseURL}#x=`))
  const { violations } = await new AxeBuilder({ page: other }).include('dialog').analyze()
  expect(violations).toEqual([])
  // Of one that came from nowhere the fragment is all there is, and the dialog says so.
  const lone = address.replace('race.html', 'lone.html')
  const text = ofFile(address).replace(/data-from="[^"]*"/, 'data-from=""')
  writeFileSync(fileURLToPath(lone), text)
  await other.goto(lone)
  await verified(other, 1)
  await other.getByTestId('share').click()
  await expect(other.getByTestId('share-link')).toHaveValue(/^#x=/)
  await expect(other.getByTestId('share-dialog')).toContainText('put this behind one')
})

test('it stores nothing, and says so', async ({ page, browser }) => {
  const address = await racePage(page)
  const { page: other } = await offline(browser)
  await other.addInitScript(() => {
    const refuse = (name: string) =>
      Object.defineProperty(window, name, {
        get: () => {
          throw new Error(`${name} was touched`)
        },
      })
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB', 'caches']) refuse(name)
    window.touched = []
    for (const [store, what] of [[navigator, 'locks']] as const)
      Object.defineProperty(store, what, { get: () => window.touched.push(what) && undefined })
  })
  await other.goto(address)
  await verified(other, 1)
  await other.getByTestId('theme').click()
  await other.getByTestId('theme-dark').click()
  await other.getByTestId('language').click()
  await other.getByTestId('language-zh-CN').click()
  await expect(other.getByTestId('share')).toContainText('分享')
  await other.getByTestId('share').click()
  await expect(other.getByTestId('share-page-hint')).toContainText('不在浏览器中保存任何内容')
  await other.keyboard.press('Escape')
  await other.getByTestId('view-lab').click()
  await expect(other.getByTestId('kept')).toContainText('此页面是单个文件')
  expect(await other.evaluate(() => window.touched)).toEqual([])
})

test('leaving asks after an edit, until it is saved', async ({ page, browser }) => {
  const address = await racePage(page)
  const { page: other } = await offline(browser)
  await other.goto(address)
  await verified(other, 1)
  const asks = () =>
    other.evaluate(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })))
  expect(await asks()).toBe(false)
  await other.getByTestId('reset').click()
  await new RacePage(other).drag([
    [4, 19],
    [9, 19],
  ])
  await expect.poll(asks).toBe(true)
  await shared(other, 'edited.html')
  expect(await asks()).toBe(false)
})

test.describe('over http in a sandboxed frame', () => {
  test('runs and verifies', async ({ page }) => {
    const file = fileURLToPath(await racePage(page))
    const server = createServer(({ url }, answer) => {
      answer.setHeader('Content-Type', 'text/html')
      if (url === '/race.html') createReadStream(file).pipe(answer)
      else answer.end('<iframe sandbox="allow-scripts" src="race.html" width=1200 height=800>')
    }).listen(0)
    const { port } = server.address() as AddressInfo
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(`${error}`))
    await page.goto(`http://localhost:${port}/`)
    const frame = page.frameLocator('iframe')
    await verified(frame, 1, 2)
    await frame.getByTestId('view-lab').click()
    await expect(frame.getByTestId('builder')).toBeVisible()
    await frame.getByTestId('lab-start').click()
    await expect(frame.getByTestId('run-bar')).toBeVisible()
    expect(errors).toEqual([])
    server.close()
  })
})

test('what is wrong with a file is said in words', async ({ browser }) => {
  const whole = readFileSync(TEMPLATE, 'utf8')
  const characters = Number(/data-characters="(\d+)"/.exec(whole)?.[1])
  const spoilt = (name: string, text: string) => {
    const file = test.info().outputPath(name)
    writeFileSync(file, text)
    return pathToFileURL(file).href
  }
  const at = whole.indexOf('id="packed">') + 'id="packed">'.length
  const { page } = await offline(browser)
  const line = page.locator('#unpacking')
  await page.goto(spoilt('cut.html', whole.slice(0, at + 1000)))
  await expect(line).toContainText(`1000 of ${characters} characters`)
  await page.goto(spoilt('head.html', whole.slice(0, whole.indexOf('id="carried"'))))
  await expect(line).toContainText(`0 of ${characters} characters`)
  const middle = at + (characters >> 1)
  const changed = `${whole.slice(0, middle)}AAAAAAAA${whole.slice(middle + 8)}`
  await page.goto(spoilt('changed.html', changed))
  await expect(line).toContainText('damaged')
})

test('the command line makes the same page', async ({ page, browser }) => {
  const cli = process.env.FORMICARIUM_CLI
  test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')
  const address = await racePage(page)
  const session = test.info().outputPath('race.experiment.json')
  await page.getByTestId('share').click()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId('share-file').click(),
  ])
  await download.saveAs(session)
  const made = (template: string) =>
    execFileSync(cli ?? '', ['page', session, '--page', template], { maxBuffer: 1 << 24 })
  // Of a page that was saved it keeps the address that it came from: then not a byte differs.
  expect(made(fileURLToPath(address)).equals(readFileSync(fileURLToPath(address)))).toBe(true)
  const file = test.info().outputPath('made.html')
  writeFileSync(file, made(TEMPLATE))
  const { page: other, complaints } = await offline(browser)
  await other.goto(pathToFileURL(file).href)
  await verified(other, 1, 2)
  expect(complaints).toEqual([])
})

test('where the page cannot be fetched, the dialog says what to do', async ({ page }) => {
  await new RacePage(page).openAtRest()
  await page.getByTestId('share').click()
  await expect(page.getByTestId('share-page-hint')).toContainText(`${ABOUT_MB} MB`)
  await page.context().setOffline(true)
  await page.getByTestId('share-page').click()
  await expect(page.getByTestId('share-page-refused')).toContainText('Save as a page')
  await page.context().setOffline(false)
  await savedPage(page, 'share-page', 'race.html')
  await expect(page.getByTestId('share-page-refused')).toHaveCount(0)
})

declare global {
  interface Window {
    /** What of the browser's own storage was asked for. */
    touched: string[]
  }
}
