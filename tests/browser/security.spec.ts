/** The built page carries a strict policy (www/content_security.ts), and nothing that it does breaks it or asks another server. */
import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { ASC } from './rasters'

const CHANNEL = 'policy-violations'
const SMALL_MAP = 'type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n'
/** Two maps, three planners, five seeds. */
const STUDY = join(__dirname, '../fixtures/links/0.1.0/study.result.json')

/** Collects what breaks the policy, on the page and in its workers, and what is asked of other servers. */
class Guard {
  readonly broken: string[] = []
  readonly foreign: string[] = []

  static async on(page: Page): Promise<Guard> {
    const guard = new Guard()
    await page.exposeFunction('policyBroken', (what: string) => guard.broken.push(what))
    await page.addInitScript((channel) => {
      const tell = (window as unknown as { policyBroken(what: string): void }).policyBroken
      new BroadcastChannel(channel).onmessage = ({ data }) => tell(String(data))
      document.addEventListener('securitypolicyviolation', (violation) =>
        tell(`${violation.effectiveDirective} of ${violation.blockedURI}, ${violation.sourceFile}`),
      )
    }, CHANNEL)
    page.on('worker', (worker) => {
      const listen = worker.evaluate((channel) => {
        const told = new BroadcastChannel(channel)
        addEventListener('securitypolicyviolation', (violation) => {
          const { effectiveDirective, blockedURI } = violation as SecurityPolicyViolationEvent
          told.postMessage(`${effectiveDirective} of ${blockedURI}, in a worker`)
        })
      }, CHANNEL)
      // Some are gone before they can be asked.
      void listen.catch(() => {})
    })
    page.on('console', (message) => {
      if (/content security policy|refused to/i.test(message.text()))
        guard.broken.push(message.text())
    })
    page.on('pageerror', (error) => guard.broken.push(`${error}`))
    page.context().on('request', (request) => {
      const { origin, protocol } = new URL(request.url())
      if (!['data:', 'blob:', 'about:'].includes(protocol) && origin !== guard.home(page))
        guard.foreign.push(request.url())
    })
    return guard
  }

  expectPeace(): void {
    expect(this.broken).toEqual([])
    expect(this.foreign).toEqual([])
  }

  private home(page: Page): string {
    const base = new URL(page.url()).origin
    return base === 'null' ? new URL(test.info().project.use.baseURL ?? '').origin : base
  }
}

async function opened(page: Page): Promise<Guard> {
  const guard = await Guard.on(page)
  await page.goto('./')
  await ready(page)
  return guard
}

async function ready(page: Page): Promise<void> {
  await expect(page.getByTestId('play')).toBeVisible()
  await page.waitForFunction(() => {
    const all = window.formicarium?.session() && window.formicarium.results()
    return all?.every((one) => one.summary !== null)
  })
}

async function atRest(page: Page): Promise<void> {
  await page.getByTestId('reset').click()
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
}

async function menu(page: Page, ...testIds: string[]): Promise<void> {
  for (const testId of testIds) await page.getByTestId(testId).click()
}

async function leaveDialog(page: Page): Promise<void> {
  await page.keyboard.press('Escape')
  await expect(page.locator('dialog')).toHaveCount(0)
}

async function drop(page: Page, name: string, content: string | Buffer): Promise<void> {
  const file = [name, Buffer.from(content).toString('base64')]
  const transfer = await page.evaluateHandle(([fileName, text]) => {
    const data = new DataTransfer()
    const bytes = Uint8Array.from(atob(text ?? ''), (char) => char.charCodeAt(0))
    data.items.add(new File([bytes], fileName ?? ''))
    return data
  }, file)
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer })
}

async function saved(page: Page, testId: string): Promise<Buffer> {
  await expect(page.getByTestId(testId)).toBeEnabled()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(testId).click(),
  ])
  return readFileSync(await download.path())
}

const policyOf = (html: string) =>
  /<meta http-equiv="Content-Security-Policy" content="([^"]*)"/
    .exec(html)?.[1]
    ?.replaceAll('&#39;', "'") ?? ''

const directive = (policy: string, name: string) =>
  policy
    .split('; ')
    .find((part) => part.startsWith(`${name} `))
    ?.split(' ')
    .slice(1) ?? []

test.describe('the policy', () => {
  test('stands in the page before everything that it is about', async ({ page }) => {
    const html = await (await page.request.get('./')).text()
    const policy = policyOf(html)
    expect(html.indexOf(policy.slice(0, 11))).toBeLessThan(html.search(/<script|<link|<style/))
    expect(policy).not.toMatch(/'unsafe-inline'|'unsafe-eval'|\*|https?:/)
    expect(directive(policy, 'default-src')).toEqual(["'self'"])
    expect(directive(policy, 'object-src')).toEqual(["'none'"])
    expect(directive(policy, 'base-uri')).toEqual(["'none'"])
    expect(directive(policy, 'form-action')).toEqual(["'none'"])
    expect(html).toContain('<meta name="referrer" content="no-referrer"')
  })

  test('names each inline script by its hash, and no other', async ({ page }) => {
    const html = await (await page.request.get('./')).text()
    const inline = [...html.matchAll(/<script>([\s\S]*?)<\/script>/g)].map(
      ([, script = '']) => script,
    )
    expect(inline.length).toBeGreaterThan(0)
    const hashes = inline.map(
      (script) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`,
    )
    const sources = directive(policyOf(html), 'script-src')
    expect(sources.sort()).toEqual(["'self'", "'wasm-unsafe-eval'", ...hashes].sort())
    // Handlers and styles in attributes would need words that the policy does not have.
    expect(html).not.toMatch(/\son\w+=|\sstyle=|<style/)
  })

  test('stops a changed script, code from text, and words to another server', async ({ page }) => {
    const guard = await Guard.on(page)
    await page.route('**/', async (route) => {
      const response = await route.fetch()
      const html = await response.text()
      await route.fulfill({
        response,
        body: html.replace('<script>', '<script>window.changed = true;'),
      })
    })
    await page.goto('./')
    await expect.poll(() => guard.broken.join()).toContain('script-src')
    expect(await page.evaluate(() => 'changed' in window)).toBe(false)
    guard.broken.length = 0
    const tried = await page.evaluate(async () => {
      const answer = await fetch('https://example.org/').then(
        () => 'sent',
        () => 'stopped',
      )
      // As text: what is evaluated from outside by the browser's tools is above the policy.
      const script = document.createElement('script')
      script.textContent = 'window.added = true'
      document.body.append(script)
      return [answer, 'added' in window]
    })
    expect(tried).toEqual(['stopped', false])
    await expect.poll(() => guard.broken.join()).toContain('connect-src of https://example.org')
  })
})

test.describe('nothing breaks it', () => {
  test('in a race: planners, looking back, cells, differences', async ({ page }) => {
    const guard = await opened(page)
    await atRest(page)
    await page.getByTestId('add-panel').click()
    await page.getByTestId('add-ant-colony-system').click()
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await ready(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    await page.getByTestId('scrubber').fill('2')
    await expect(page.getByTestId('looking-back')).toBeVisible()
    await page.getByTestId('back-to-now').click()
    await page.locator('body').press('i')
    const stage = page.getByTestId('panel-1').locator('.stage')
    await stage.focus()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('moves-card')).toBeVisible()
    await page.keyboard.press('Escape')
    await page.getByTestId('compare-trails').click()
    await expect(page.getByTestId('difference-normalised')).toContainText('A ')
    await page.getByTestId('close-difference').click()
    await page.getByTestId('layer').selectOption('visits')
    await page.getByTestId('play').click()
    await expect
      .poll(() =>
        page.evaluate(() => window.formicarium.results()[0]?.summary?.effort.iterations ?? 0),
      )
      .toBeGreaterThan(6)
    guard.expectPeace()
  })

  test('with files: a map, a terrain from above, in three dimensions and as a profile', async ({
    page,
  }) => {
    const guard = await opened(page)
    await atRest(page)
    await drop(page, 'small.map', SMALL_MAP)
    await expect
      .poll(() => page.evaluate(() => window.formicarium.session()?.scenario.cells.length))
      .toBe(12)
    await drop(page, 'small.asc', ASC)
    await expect(page.getByTestId('raster-preview')).toBeVisible()
    await page.getByTestId('terrain-open').click()
    await expect(page.getByTestId('terrain-dialog')).toBeHidden()
    await ready(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await page.getByTestId('chart-profile').click()
    await expect(page.getByTestId('profile').locator('canvas')).toBeVisible()
    await page.getByTestId('view-solid').click()
    await expect(page.getByTestId('stretch')).toBeVisible()
    for (const format of ['movingai-map', 'scenario']) {
      await menu(page, 'map-menu', 'open-export', `export-${format}`)
      expect((await saved(page, 'export-download')).length).toBeGreaterThan(0)
      await leaveDialog(page)
    }
    guard.expectPeace()
  })

  test('in a comparison: all tabs, figures and files', async ({ page }) => {
    const guard = await opened(page)
    await page.evaluate(
      async (text) => {
        const { recorded, rows, ...document } = JSON.parse(text)
        await window.formicarium.compare({ document: JSON.stringify(document) })
        return [recorded, rows].length
      },
      readFileSync(STUDY, 'utf8'),
    )
    await expect(page.getByTestId('lab')).toHaveAttribute('data-phase', 'done', { timeout: 60_000 })
    await page.getByTestId('results-tab-figures').click()
    await expect(page.getByTestId('figure-values').locator('.figure-picture > svg')).toBeVisible()
    for (const kind of ['svg', 'png']) {
      const picture = await saved(page, `figure-values-${kind}`)
      expect(picture.length).toBeGreaterThan(1000)
    }
    for (const tab of ['tests', 'reported', 'files', 'summary']) {
      const button = page.getByTestId(`results-tab-${tab}`)
      if ((await button.count()) > 0) await button.click()
      if (tab === 'files')
        for (const kind of ['csv', 'json', 'latex']) await saved(page, `file-${kind}`)
    }
    await page.getByTestId('lab-share').click()
    await expect(page.getByTestId('lab-share-link')).toHaveValue(/#q=/)
    expect((await saved(page, 'lab-share-picture')).length).toBeGreaterThan(1000)
    await leaveDialog(page)
    await drop(page, 'study.result.json', readFileSync(STUDY))
    await expect(page.getByTestId('verification')).toBeVisible()
    guard.expectPeace()
  })

  test('in a film, a moving picture, slides, and codes of the link', async ({ page }) => {
    const guard = await opened(page)
    await atRest(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await menu(page, 'share', 'link-code', 'link-code-large')
    await expect(page.getByTestId('link-code-screen')).toBeVisible()
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('link-code-screen')).toHaveCount(0)
    await saved(page, 'link-code-save')
    await menu(page, 'share-film')
    await page.getByTestId('film-seconds').fill('7')
    await page.getByTestId('film-seconds').press('Tab')
    for (const what of ['film', 'steps', 'slides']) {
      await menu(page, `film-${what}`, 'film-make')
      await saved(page, 'film-save')
      await menu(page, 'film-again')
    }
    guard.expectPeace()
  })

  test('within another page', async ({ page }) => {
    const guard = await Guard.on(page)
    await page.goto('./?embed=play,step,numbers,layers,edit,charts,open')
    await ready(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await expect(page.locator('.embedded-charts canvas').first()).toBeVisible()
    await page.getByTestId('full-page').hover()
    await expect(page.getByTestId('full-page')).toHaveAttribute('href', /#x=/)
    await page.evaluate(() => window.formicarium.compare({ planners: ['astar'], seeds: 2 }))
    guard.expectPeace()
  })

  test('when shared, read about, in Chinese and in the dark', async ({ page }) => {
    const guard = await opened(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await page.getByTestId('share').click()
    await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
    const link = await page.getByTestId('share-link').inputValue()
    const picture = await saved(page, 'share-picture')
    await leaveDialog(page)
    await drop(page, 'race.png', picture)
    await ready(page)
    await page.goto('about:blank')
    await page.goto(link)
    await ready(page)
    await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
    await menu(page, 'add-panel', 'about-acost')
    await expect(page.getByTestId('card-dialog').locator('table').first()).toBeVisible()
    await leaveDialog(page)
    await menu(page, 'language', 'language-zh-CN')
    await expect(page.locator('html')).toHaveAttribute('lang', /^zh/)
    await expect(page.getByTestId('share')).toContainText(/\p{Script=Han}/u)
    await menu(page, 'theme', 'theme-dark')
    await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark')
    await page.reload()
    await ready(page)
    await page.getByTestId('help').click()
    await expect(page.getByTestId('help-dialog')).toBeVisible()
    guard.expectPeace()
  })
})
