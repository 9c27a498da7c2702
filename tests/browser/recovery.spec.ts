/** What cannot be fetched is said, and comes when it can be fetched again; a browser that cannot run the page fetches nothing of it. */
import { type BrowserContext, expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

/** A planner that only the whole engine has. */
const LATER = 'max-min-ant-system'

const PARTS = /\/assets\/.*\.(js|css)$/

/** Fails what is fetched from now on, until the answer is called. */
async function failing(
  context: BrowserContext,
  files: RegExp,
  how: 'connection' | 'gone' | 'page instead',
): Promise<() => Promise<void>> {
  await context.route(files, (route) => {
    if (how === 'connection') return route.abort('internetdisconnected')
    if (how === 'gone') return route.fulfill({ status: 404, body: 'not here' })
    return route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>page</title>' })
  })
  return () => context.unroute(files)
}

/** The page may have been fetching more at that moment, which says the same of itself. */
const toast = (page: Page, text: string) =>
  page.getByTestId('toast-error').filter({ hasText: text }).first()

test.describe('a part of the page', () => {
  test('that did not come once is there when it is asked for again', async ({ page, context }) => {
    await new RacePage(page).openAtRest()
    const mend = await failing(context, PARTS, 'connection')
    await page.getByTestId('view-lab').click()
    await expect(toast(page, 'could not be fetched')).toBeVisible()
    await expect(page.getByTestId('play')).toBeVisible()
    await mend()
    await page.getByTestId('view-lab').click()
    await expect(page.getByTestId('lab')).toBeVisible()
  })

  for (const how of ['gone', 'page instead'] as const)
    test(`that a newer version has taken away (${how}): reload is offered, and keeps the map`, async ({
      page,
      context,
    }) => {
      const race = new RacePage(page)
      await race.openAtRest()
      await page.getByTestId('planner-1').selectOption('ant-colony-system')
      await race.ready()
      // What is kept through a reload comes once the page is idle.
      const kept = () => page.evaluate(() => sessionStorage.getItem('formicarium.session'))
      await expect.poll(kept).not.toBeNull()
      const mend = await failing(context, PARTS, how)
      await page.getByTestId('view-lab').click()
      await expect(toast(page, 'newer version')).toBeVisible()
      await mend()
      await toast(page, 'newer version').getByRole('button', { name: 'Reload' }).click()
      await race.ready()
      await expect(page.getByTestId('planner-1')).toHaveValue('ant-colony-system')
    })
})

test('metres without their Chinese are told in English, and in Chinese once it can be fetched', async ({
  page,
  context,
}) => {
  const failed: string[] = []
  page.on('pageerror', ({ message }) => failed.push(message))
  await page.addInitScript(() => Object.defineProperty(navigator, 'language', { value: 'zh-CN' }))
  const words = /\/assets\/reading-.*\.js$/
  await context.route(words, async (route) => {
    const response = await route.fetch()
    if (/\p{Script=Han}/u.test(await response.text())) await route.abort('internetdisconnected')
    else await route.fulfill({ response })
  })
  const race = new RacePage(page)
  await race.open()
  const map = { format: 'formicarium/scenario@1', name: 'room', width: 6, height: 2 }
  const ends = { resolution: 0.5, start: [0, 0], goals: [{ at: [5, 0] }] }
  const text = JSON.stringify({ ...map, ...ends, map: { rows: ['......', '......'] } })
  await race.evaluate((text) => window.formicarium.load(text), text)
  await expect(page.getByTestId('optimum')).toContainText('2.50 m')
  await context.unrouteAll({ behavior: 'wait' })
  await race.menu('map-menu', 'open-resize')
  await expect(page.getByTestId('robot-fields')).toBeVisible()
  await race.leaveDialog()
  await race.drag([[3, 1]])
  await expect(page.getByTestId('optimum')).toContainText('2.50 米')
  expect(failed).toEqual([])
})

test.describe('offline', () => {
  test('a planner that is not here says so, and comes with the connection', async ({
    page,
    context,
  }) => {
    // The core is here, what it is a part of never came.
    let whole = 0
    await context.route(/\.wasm$/, (route) => {
      whole += 1
      return whole === 1 ? route.continue() : route.abort('internetdisconnected')
    })
    const race = new RacePage(page)
    await race.openAtRest()
    await page.evaluate((planner) => {
      const session = window.formicarium.session()
      const [panel] = session?.panels ?? []
      if (!session || !panel) return
      const panels = [{ ...panel, planner, result: null }]
      return window.formicarium.load({ ...session, panels }).catch(() => {})
    }, LATER)
    await expect(page.getByTestId('panel-not-fetched')).toContainText('could not be fetched')
    await expect(page.getByTestId('panel-1')).not.toContainText('unexpectedly')
    await context.unroute(/\.wasm$/)
    await page.evaluate(() => dispatchEvent(new Event('online')))
    await expect(page.getByTestId('panel-not-fetched')).toBeHidden()
    await race.ready()
    expect((await race.result(1)).planner).toBe(LATER)
  })
})

test.describe('a browser that cannot run the page', () => {
  const LACKS: [string, string, () => void][] = [
    [
      'canvases in workers',
      'OffscreenCanvas',
      () => Reflect.deleteProperty(window, 'OffscreenCanvas'),
    ],
    ['packing', 'CompressionStream', () => Reflect.deleteProperty(window, 'CompressionStream')],
    [
      '128-bit numbers',
      'WebAssembly SIMD',
      () => Object.assign(WebAssembly, { validate: () => false }),
    ],
    [
      'modules in workers',
      'module workers',
      () => {
        window.Worker = class {} as unknown as typeof Worker
      },
    ],
  ]
  for (const [what, name, without] of LACKS)
    test(`is told what it lacks, and fetches nothing: ${what}`, async ({ page }) => {
      const fetched: string[] = []
      page.on('request', (request) => fetched.push(new URL(request.url()).pathname))
      await page.addInitScript(without)
      await page.goto('./')
      await expect(page.getByTestId('cannot-start')).toContainText(name)
      await expect(page.getByTestId('cannot-start')).toContainText('Firefox 115')
      await page.waitForLoadState('networkidle')
      expect(fetched.filter((path) => /\.(js|wasm)$/.test(path))).toEqual([])
    })

  test('a page whose own script does not come says so', async ({ page, context }) => {
    await failing(context, /\/assets\/index-.*\.js$/, 'connection')
    await page.goto('./')
    await expect(page.getByTestId('cannot-start')).toContainText('could not be fetched')
    await context.unroute(/\/assets\/index-.*\.js$/)
    await page.getByTestId('cannot-start').getByRole('link').click()
    await new RacePage(page).ready()
  })
})
