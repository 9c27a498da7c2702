/** The copy of the page for days without a network: made when the page rests, and replaced only when the reader asks. */
import { execFileSync } from 'node:child_process'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { savedPage } from './saved_pages'
import { StaticHost } from './static_host'

test.use({ serviceWorkers: 'allow' })

let host: StaticHost

test.beforeEach(async () => {
  host = await StaticHost.start('/lab/colony/')
})
test.afterEach(() => host.remove())

const toast = (page: Page, text: string) => page.getByTestId('toast-info').filter({ hasText: text })

async function opened(page: Page, address = host.address): Promise<RacePage> {
  await page.goto(address)
  const race = new RacePage(page)
  await race.ready()
  return race
}

/** Opens the page and waits until all of it is kept. */
async function kept(page: Page): Promise<void> {
  await opened(page)
  await expect(toast(page, 'kept on this device')).toBeVisible({ timeout: 60_000 })
}

/** Puts up a version whose engine gives other results for a planner. */
function putUpNewer(planner: string): void {
  host.change('version.json', (text) => {
    const version = JSON.parse(text)
    version.results[planner] = 'another'
    return JSON.stringify(version)
  })
  host.change('index.html', (html) => html.replace('<title>', '<meta name="newer"><title>'))
  // Built again as the build does it.
  execFileSync(
    'node',
    [
      'node_modules/vite/bin/vite.js',
      ...['build', '--config', 'service_worker.config.ts', '--logLevel', 'error'],
      ...['--outDir', host.folder],
    ],
    { cwd: join(__dirname, '../../www') },
  )
}

const isNewer = (page: Page) => page.locator('meta[name="newer"]').count()

test.describe('without a network', () => {
  test('the page opens with everything: planners, cards, both languages, comparisons, terrains', async ({
    page,
  }) => {
    test.slow()
    await kept(page)
    host.stop()
    await page.reload()
    const race = new RacePage(page)
    await race.ready()
    await page.getByTestId('reset').click()
    await page.getByTestId('planner-1').selectOption('max-min-ant-system')
    await race.ready()
    const [first] = await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    expect(first?.planner).toBe('max-min-ant-system')
    expect(first?.summary?.digest).toMatch(/^[0-9a-f]{16}$/)
    // Sharing, and what a link brings.
    const link = await race.shareLink()
    await page.goto('about:blank')
    await page.goto(link)
    await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
    // A card, in both languages.
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN')
    await page.getByTestId('help').click()
    await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'kept')
    await page.keyboard.press('Escape')
    // A comparison, and a terrain of the gallery.
    const compared = await page.evaluate(() =>
      window.formicarium.compare({ planners: ['ant-system', 'astar'], seeds: 2 }),
    )
    expect(compared.failed).toBe(0)
    await page.goto(`${host.address}?any=words#lab`)
    await expect(page.getByTestId('lab')).toBeVisible()
    await page.getByTestId('view-race').click()
    // The card of a paper, a terrain in three dimensions, a lesson, and the page as one file.
    await race.menu('map-menu', 'gallery-paper-ship-20')
    await race.ready()
    await page.getByTestId('add-panel').click()
    await page.getByTestId('about-ship').click()
    await expect(page.getByTestId('card-dialog')).toContainText('2026')
    await page.keyboard.press('Escape')
    await race.menu('map-menu', 'gallery-terrain-hills')
    await race.ready()
    await page.locator('body').press('3')
    await expect(page.locator('.stage.relief canvas').first()).toBeVisible()
    await page.goto(`${host.address}#lesson=bridge`)
    await expect(page.getByTestId('guide')).toBeVisible()
    await page.getByTestId('share').click()
    expect((await savedPage(page, 'share-page', 'lesson.html')).endsWith('.html')).toBe(true)
  })

  test('nothing is fetched twice for it, and nothing before the page rests', async ({ page }) => {
    await kept(page)
    const first = host.asked.indexOf('/lab/colony/sw.js')
    const wasm = host.asked.findLastIndex((path, i) => path.endsWith('.wasm') && i < first)
    expect(wasm).toBeGreaterThan(0)
    expect(host.asked.slice(0, first).filter((path) => path.endsWith('.wasm'))).toHaveLength(2)
  })
})

test.describe('a newer version', () => {
  test('waits until it is asked for, and says which planners give other results', async ({
    page,
    context,
  }) => {
    await kept(page)
    putUpNewer('ant-system')
    await opened(page)
    // The whole newer version is fetched and checked before it is told of.
    await expect(toast(page, 'newer version')).toContainText('Ant System gives other results', {
      timeout: 60_000,
    })
    await expect(toast(page, 'newer version')).toContainText('One panel on this page is touched')
    // Closed and opened again, it is still the former one.
    await page.close()
    const again = await context.newPage()
    const race = await opened(again)
    expect(await isNewer(again)).toBe(0)
    await again.getByTestId('reset').click()
    await again.getByTestId('planner-1').selectOption('ant-colony-system')
    await race.ready()
    await again.waitForTimeout(600)
    await toast(again, 'newer version').getByRole('button', { name: 'Use the newer' }).click()
    await expect.poll(() => isNewer(again)).toBe(1)
    await race.ready()
    await expect(again.getByTestId('planner-1')).toHaveValue('ant-colony-system')
    // It is whole: the former one is gone, the network too.
    host.stop()
    await opened(again)
    expect(await isNewer(again)).toBe(1)
    const caches = await again.evaluate(async () => (await window.caches.keys()).length)
    expect(caches).toBe(2)
  })

  test('with the same results says so', async ({ page }) => {
    await kept(page)
    putUpNewer('no-planner')
    await opened(page)
    await expect(toast(page, 'newer version')).toContainText('stay verified')
  })
})

test.describe('the copy', () => {
  test('can be removed, is not made again, and can be made again', async ({ page }) => {
    await kept(page)
    await page.getByTestId('help').click()
    await expect(page.getByTestId('offline')).toContainText('MB')
    await page.getByTestId('offline-drop').click()
    await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'off')
    expect(await page.evaluate(async () => await window.caches.keys())).toEqual([])
    await opened(page)
    await page.getByTestId('help').click()
    await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'off')
    const registered = () =>
      page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length)
    expect(await registered()).toBe(0)
    await page.getByTestId('offline-keep').click()
    await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'kept', {
      timeout: 60_000,
    })
  })

  test('that did not come whole is not used, and said', async ({ page, context }) => {
    host.change('version.json', () => '')
    await context.route('**/version.json*', (route) => route.abort())
    host.change('sw.js', (code) => code.replace('version.json', 'nowhere.json'))
    await opened(page)
    await page.getByTestId('help').click()
    await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'failed')
  })
})

test('the manifest names the page, its icons and the files that it opens', async ({ page }) => {
  await page.goto(host.address)
  const href = await page.locator('link[rel="manifest"]').getAttribute('href')
  const at = new URL(href ?? '', host.address)
  const manifest = await (await page.request.get(at.href)).json()
  for (const { src, sizes, type } of manifest.icons) {
    const icon = await page.request.get(new URL(src, at).href)
    expect(icon.headers()['content-type']).toBe(type)
    if (sizes === 'any') continue
    const png = await icon.body()
    expect(`${png.readUInt32BE(16)}x${png.readUInt32BE(20)}`).toBe(sizes)
  }
  const accepted = Object.values(manifest.file_handlers[0].accept).flat()
  for (const ending of ['.map', '.scen', '.yaml', '.png', '.json'])
    expect(accepted).toContain(ending)
})

test('a file that the system opens with the page is opened there', async ({ page }) => {
  await page.addInitScript(() => {
    const map = 'type octile\nheight 3\nwidth 5\nmap\n.....\n.@@@.\n.....\n'
    const handle = { getFile: async () => new File([map], 'small.map') }
    const queue = {
      setConsumer: (take: (launch: { files: unknown[] }) => void) => take({ files: [handle] }),
    }
    Object.defineProperty(window, 'launchQueue', { value: queue })
  })
  await opened(page)
  await expect
    .poll(() => page.evaluate(() => window.formicarium.session()?.scenario.spec.name))
    .toContain('small')
})
