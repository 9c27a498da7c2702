import {
  type Browser,
  type BrowserContext,
  expect,
  type Page,
  type Request,
  test,
} from '@playwright/test'
import { freshRace, RacePage } from './race_page'
import { drawn } from './workers'

/** A planner that the core of the engine does not have. */
const LATER = 'max-min-ant-system'

/** Holds back every engine but the first that is asked for, the core, until what it answers with is called. */
async function holdWhole(context: BrowserContext, how: 'fail' | 'wait'): Promise<() => void> {
  let core = ''
  let pass = () => {}
  let open = false
  const passed = new Promise<void>((resolve) => {
    pass = () => {
      open = true
      resolve()
    }
  })
  await context.route(/\.wasm$/, async (route) => {
    core ||= route.request().url()
    if (route.request().url() !== core && !open) {
      if (how === 'fail') return route.abort('internetdisconnected')
      await passed
    }
    return route.continue()
  })
  return pass
}

/** Resolves once `file` has been fetched, and nothing is on its way any more. To be called before the page is opened. */
function fetched(page: Page, file: RegExp): () => Promise<void> {
  const underWay = new Set<Request>()
  let seen = false
  page.on('request', (request) => underWay.add(request))
  page.on('requestfailed', (request) => underWay.delete(request))
  page.on('requestfinished', (request) => {
    underWay.delete(request)
    seen ||= file.test(request.url())
  })
  return () => expect.poll(() => seen && underWay.size === 0).toBe(true)
}

/** A link to a race of both kinds of planners, recorded after some iterations. */
async function linkToLater(page: Page): Promise<string> {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('planner-1').selectOption(LATER)
  await race.ready()
  await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
  return race.shareLink()
}

/** The link, opened by somebody whose whole engine is held back until `pass`. */
async function openLater(
  page: Page,
  browser: Browser,
  how: 'fail' | 'wait',
): Promise<{ opened: Page; pass: () => void }> {
  const link = await linkToLater(page)
  const context = await browser.newContext()
  const pass = await holdWhole(context, how)
  const opened = await context.newPage()
  await opened.goto(link)
  return { opened, pass }
}

test.describe('the planners of the whole engine', () => {
  test('are on offer without a click, and take over a panel and give it back', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const planner = page.getByTestId('planner-1')
    await planner.selectOption(LATER)
    await race.ready()
    await expect(page.getByTestId('panel-waiting')).toBeHidden()
    await expect(page.getByTestId('panel-1').locator('.stage canvas')).toHaveCount(1)
    await race.seesMotion(1, () => page.getByTestId('play').click())
    expect((await race.result(1)).planner).toBe(LATER)
    await planner.selectOption('ant-system')
    await expect.poll(async () => (await race.result(1)).planner).toBe('ant-system')
    await race.ready()
    await drawn(page)
    await race.seesMotion(1)
  })

  test('run as in the core: the same planner gives the same digest in both', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    // The second panel gets the whole engine, and keeps it.
    await page.getByTestId('planner-2').selectOption(LATER)
    await race.ready()
    await page.getByTestId('planner-2').selectOption('ant-system')
    await race.ready()
    const [core, whole] = await page.evaluate(() => window.formicarium.run({ iterations: 12 }))
    expect(core?.summary?.iteration).toBe(12)
    expect(whole?.summary?.digest).toBe(core?.summary?.digest)
  })

  test('come with a link that names one: its panel waits, and the run is verified', async ({
    page,
    browser,
  }) => {
    const { opened, pass: release } = await openLater(page, browser, 'wait')
    await expect(opened.getByTestId('panel-1').getByTestId('panel-waiting')).toBeVisible()
    await expect(opened.getByTestId('planner-1')).toHaveValue(LATER)
    await expect(opened.getByTestId('panel-2')).toBeVisible()
    release()
    await expect(opened.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
    await expect(opened.getByTestId('panel-waiting')).toBeHidden()
    await expect(opened.getByTestId('parameters-1')).toBeVisible()
    expect((await new RacePage(opened).session()).panels[0]?.planner).toBe(LATER)
    await opened.context().close()
  })

  test('that cannot be fetched leave the page as it is, until one tries again', async ({
    page,
    browser,
  }) => {
    const { opened, pass: reconnect } = await openLater(page, browser, 'fail')
    const race = new RacePage(opened)
    const alert = opened.getByTestId('panel-not-fetched')
    await expect(alert).toBeVisible()
    // The planner that is here runs meanwhile.
    await expect
      .poll(async () => (await race.result(2)).summary?.effort.cell_expansions ?? 0)
      .toBeGreaterThan(0)
    expect(await race.walls()).toBeGreaterThan(0)
    reconnect()
    await alert.getByRole('button').click()
    await expect(opened.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
    await expect(alert).toBeHidden()
    await race.ready()
    await opened.context().close()
  })

  test('outlive the connection: sharing works, and what is missing is said', async ({ page }) => {
    const dialogs = fetched(page, /all_dialogs/)
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('add-panel').click()
    await expect(page.getByTestId(`add-${LATER}`)).toBeVisible()
    await page.keyboard.press('Escape')
    await dialogs()
    await page.context().setOffline(true)
    expect(await race.shareLink()).toContain('#x=')
    await race.menu('map-menu', 'gallery-paper-ship-20')
    await expect(page.getByText('This part of the page could not be fetched.')).toBeVisible()
    await page.context().setOffline(false)
    await race.menu('map-menu', 'gallery-paper-ship-20')
    await expect(page.getByTestId('planner-1')).toHaveValue('ship')
  })

  test('can be asked for again in the menu, and a panel that waits starts', async ({
    page,
    browser,
  }) => {
    const { opened, pass: reconnect } = await openLater(page, browser, 'fail')
    await expect(opened.getByTestId('panel-not-fetched')).toBeVisible()
    await opened.getByTestId('add-panel').click()
    const again = opened.getByTestId('fetch-planners')
    await expect(again).toBeVisible()
    reconnect()
    await again.click()
    await opened.getByTestId('add-panel').click()
    await expect(opened.getByTestId(`add-${LATER}`)).toBeVisible()
    await expect(again).toBeHidden()
    await new RacePage(opened).ready()
    await expect(opened.getByTestId('panel-1').getByRole('alert')).toBeHidden()
    await expect(opened.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
    await opened.context().close()
  })

  test('that no version knows leave the page, once the catalog is complete', async ({
    browser,
  }) => {
    const race = await freshRace(browser, './')
    const { page } = race
    await page.evaluate(async () => {
      const session = window.formicarium.session()
      if (!session) throw new Error('no session')
      const stranger = { planner: 'of-tomorrow', preset: null, params: {}, result: null }
      await window.formicarium.load({ ...session, panels: [...session.panels, stranger] })
    })
    await expect(page.getByTestId('toast-warning')).toContainText('of-tomorrow')
    await expect(page.getByTestId('panel-3')).toBeHidden()
    await expect(page.getByTestId('panel-2')).toBeVisible()
    await page.context().close()
  })
})
