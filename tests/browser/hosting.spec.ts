/** The page on a plain static host, below a path, with exactly the headers of docs/hosting.md. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { headersOfDocs } from './docs_headers'
import { ASC } from './rasters'
import { StaticHost } from './static_host'

const linkOf = (name: string) =>
  readFileSync(join(__dirname, `../fixtures/links/0.1.0/${name}.link`), 'utf8').trim()

let host: StaticHost
test.beforeAll(async () => {
  host = await StaticHost.start('/a/path/ants/', headersOfDocs())
})
test.afterAll(() => host.remove())

/** Everything that a browser says against what the page does, or that could not be had. */
async function complaintsOf(page: Page): Promise<string[]> {
  const complaints: string[] = []
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text())
  })
  page.on('pageerror', (error) => complaints.push(`${error}`))
  page.context().on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`)
  })
  page.context().on('request', (request) => {
    const { origin, protocol } = new URL(request.url())
    const isOwn = ['data:', 'blob:'].includes(protocol) || origin === new URL(host.address).origin
    if (!isOwn) complaints.push(`asks ${request.url()}`)
  })
  await page.exposeFunction('complain', (what: string) => complaints.push(what))
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI }) =>
      (window as unknown as { complain(what: string): void }).complain(
        `${effectiveDirective} of ${blockedURI}`,
      ),
    )
  })
  return complaints
}

async function drop(page: Page, name: string, content: string): Promise<void> {
  const transfer = await page.evaluateHandle(
    ([fileName, text]) => {
      const data = new DataTransfer()
      data.items.add(new File([text ?? ''], fileName ?? ''))
      return data
    },
    [name, content],
  )
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer })
}

test('the docs name a strict policy, and the host sends it with every file', async ({ page }) => {
  const { 'Content-Security-Policy': policy = '', ...others } = headersOfDocs()
  expect(policy).toContain("default-src 'self'")
  expect(policy).toMatch(/script-src 'self' 'wasm-unsafe-eval' 'sha256-[^']{44}'/)
  expect(policy).not.toMatch(/unsafe-inline|'unsafe-eval'|\*|https?:|…/)
  expect(Object.keys(others)).toContain('X-Content-Type-Options')
  const answers = new Map<string, Record<string, string>>()
  page.on('response', (response) =>
    answers.set(new URL(response.url()).pathname, response.headers()),
  )
  await page.goto(host.address)
  await expect(page.getByTestId('play')).toBeVisible()
  expect(answers.size).toBeGreaterThan(4)
  for (const [path, headers] of answers) {
    expect(headers['content-security-policy'], path).toBe(policy)
    const kept = path.includes('/assets/') ? 'immutable' : 'no-cache'
    expect(headers['cache-control'], path).toContain(kept)
    if (path.endsWith('.wasm')) expect(headers['content-type']).toBe('application/wasm')
  }
})

test('a race that was sent, explained, played, looked back at and shared', async ({ page }) => {
  const complaints = await complaintsOf(page)
  await page.goto(host.address + linkOf('session'))
  await expect(page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
  await page.getByTestId('received-what').click()
  await expect(page.getByTestId('about-verified')).toContainText('Yes')
  await page.keyboard.press('Escape')
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  await page.getByTestId('scrubber').fill('2')
  await expect(page.getByTestId('looking-back')).toBeVisible()
  await page.getByTestId('share').click()
  await expect(page.getByTestId('share-link')).toHaveValue(/\/a\/path\/ants\/#x=/)
  const [picture] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId('share-picture').click(),
  ])
  expect(readFileSync(await picture.path()).length).toBeGreaterThan(1000)
  await page.keyboard.press('Escape')
  await page.getByTestId('help').click()
  await expect(page.getByTestId('help-dialog')).toBeVisible()
  expect(complaints).toEqual([])
})

test('a terrain from a file, in three dimensions', async ({ page }) => {
  const complaints = await complaintsOf(page)
  await page.goto(host.address)
  await expect(page.getByTestId('play')).toBeVisible()
  await page.getByTestId('reset').click()
  await drop(page, 'small.asc', ASC)
  await page.getByTestId('terrain-open').click()
  await expect(page.getByTestId('terrain-dialog')).toBeHidden()
  await page.getByTestId('view-solid').click()
  await expect(page.getByTestId('stretch')).toBeVisible()
  expect(complaints).toEqual([])
})

test('a comparison that was sent, run again, with its figures, in Chinese and dark', async ({
  page,
}) => {
  const complaints = await complaintsOf(page)
  await page.goto(host.address + linkOf('study'))
  await page.getByTestId('verify-again').click()
  await expect(page.getByTestId('verification')).toHaveAttribute('data-state', 'same')
  await page.getByTestId('results-tab-figures').click()
  await expect(page.getByTestId('figure-values').locator('.figure-picture > svg')).toBeVisible()
  await page.getByTestId('language').click()
  await page.getByTestId('language-zh-CN').click()
  await expect(page.locator('html')).toHaveAttribute('lang', /^zh/)
  await page.getByTestId('theme').click()
  await page.getByTestId('theme-dark').click()
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark')
  expect(complaints).toEqual([])
})

test('the card of a link is described, and its picture is there', async ({ page }) => {
  const html = await (await page.request.get(host.address)).text()
  const tag = (name: string) =>
    new RegExp(`(?:property|name)="${name}"\\s+content="([^"]*)"`).exec(html)?.[1] ?? ''
  for (const name of ['og:title', 'og:description']) expect(tag(name), name).not.toBe('')
  expect(tag('twitter:card')).toBe('summary_large_image')
  const image = await page.request.get(new URL(tag('og:image'), host.address).href)
  const png = await image.body()
  expect(png.subarray(1, 4).toString()).toBe('PNG')
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1200, 630])
  expect(png.length).toBeLessThanOrEqual(60 * 1024)
})
