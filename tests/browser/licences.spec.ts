/** What the page contains of others goes along with its licence. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { offline } from './saved_pages'

const ROOT = join(__dirname, '../..')
const manifest = JSON.parse(readFileSync(join(ROOT, 'www/package.json'), 'utf8'))
/** Bundled, though it is listed among what only builds: it makes the service worker. */
const PACKAGES = [...Object.keys(manifest.dependencies), 'workbox-precaching']
/** Of the engine; what they need is there, too. */
const CRATES = ['wasm-bindgen', 'js-sys', 'serde-wasm-bindgen', 'rand', 'libm', 'miniz_oxide']

/** The names that the file tells, each with a text. */
function namesIn(text: string): string[] {
  const [, ...notices] = text.split(/^-{72}\n/m)
  return notices.map((notice) => {
    const [heading = '', ...rest] = notice.split('\n')
    expect(rest.join('\n').trim(), heading).not.toBe('')
    return heading.split(' ')[0] ?? ''
  })
}

async function openHelp(page: Page) {
  await page.keyboard.press('?')
  return page.getByTestId('help-dialog').getByRole('link', { name: /licences/i })
}

test('the page tells of every package and crate inside it', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const link = await openHelp(page)
  const [opened] = await Promise.all([page.waitForEvent('popup'), link.click()])
  await expect(opened).toHaveURL(/licences\.txt$/)
  expect(namesIn(await opened.innerText('body'))).toEqual(
    expect.arrayContaining([...PACKAGES, ...CRATES]),
  )
})

test('so does the page of one file', async ({ browser }) => {
  const { page } = await offline(browser)
  await page.goto(`file://${join(ROOT, 'www/dist/one-file.html')}`)
  await new RacePage(page).ready()
  const link = await openHelp(page)
  const [file] = await Promise.all([page.waitForEvent('download'), link.click()])
  expect(file.suggestedFilename()).toBe('licences.txt')
  expect(namesIn(readFileSync(await file.path(), 'utf8'))).toEqual(
    expect.arrayContaining([...PACKAGES, ...CRATES]),
  )
})

test('and the npm package of every crate', () => {
  const names = namesIn(readFileSync(join(ROOT, 'pkg/licences.txt'), 'utf8'))
  expect(names).toEqual(expect.arrayContaining(CRATES))
})
