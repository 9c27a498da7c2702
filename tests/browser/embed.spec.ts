/** The page within another one: what its address asks for, and that nothing is kept or opened that the browser has. */
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { ComparisonPage, documentText } from './comparison_page'
import { RacePage } from './race_page'

const NEXT_TO = ['header', 'toolbar', 'column', 'side', 'lab-welcome']

async function openEmbedded(page: Page, query = '?embed'): Promise<RacePage> {
  await page.goto('about:blank')
  await page.goto(`./${query}`)
  const race = new RacePage(page)
  await expect(page.getByTestId('panel-1')).toBeVisible()
  await page.waitForFunction(() =>
    window.formicarium?.results().every((one) => one.summary !== null),
  )
  return race
}

test('there are maps, the bar, numbers and the mark, and nothing runs by itself', async ({
  page,
}) => {
  await page.setViewportSize({ width: 600, height: 400 })
  const race = await openEmbedded(page)
  for (const part of NEXT_TO) await expect(page.locator(`.${part}`)).toHaveCount(0)
  await expect(page.getByTestId('planner-1')).toHaveCount(0)
  await expect(page.getByTestId('gap-1')).toBeVisible()
  await expect(page.getByTestId('step-move')).toBeVisible()
  await expect(page.getByTestId('full-page')).toBeInViewport()
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
  await page.getByTestId('play').click()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  const { scrollWidth, clientWidth } = await page.evaluate(() => document.documentElement)
  expect(scrollWidth).toBe(clientWidth)
})

test('each control comes with its name, and only then', async ({ page }) => {
  await openEmbedded(page, '?embed=layers,charts')
  await expect(page.getByTestId('layer')).toBeVisible()
  await expect(page.locator('.embedded-charts')).toBeVisible()
  for (const absent of ['play', 'step-move', 'gap-1', 'undo'])
    await expect(page.getByTestId(absent)).toHaveCount(0)
  await openEmbedded(page, '?embed=edit')
  await expect(page.getByTestId('undo')).toBeVisible()
  await expect(page.getByTestId('layer')).toHaveCount(0)
})

test('what the address asks for and is not known is said with what is', async ({ page }) => {
  await openEmbedded(page, '?embed=play,sound&theme=blue')
  const said = page.getByTestId('toast-warning')
  await expect(said).toHaveCount(2)
  await expect(said.first()).toContainText('sound')
  await expect(said.first()).toContainText('play, step, numbers, layers, edit, charts, open')
  await expect(said.last()).toContainText('light, dark')
})

test('the map stays as it is unless drawing is asked for', async ({ page }) => {
  const race = await openEmbedded(page)
  const before = await race.session()
  await race.drag([before.scenario.spec.start, [20, 12]])
  await race.drag([
    [10, 3],
    [14, 3],
  ])
  await page.getByTestId('panel-1').locator('.stage').focus()
  for (const key of ['Enter', 'x', 'Delete', 'w', 'Enter', 'Control+z', 'c', '?'])
    await page.keyboard.press(key)
  expect((await race.session()).scenario).toEqual(before.scenario)
  await expect(page.locator('dialog')).toHaveCount(0)
  const drawing = await openEmbedded(page, '?embed=edit')
  await drawing.drag([[20, 12]])
  await expect(page.getByTestId('undo')).toBeEnabled()
})

test('theme and language are those of the address, and are not kept', async ({ page }) => {
  await openEmbedded(page, '?embed&theme=dark&lang=zh-CN')
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark')
  await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN')
  await expect(page.getByTestId('play')).toContainText(/\p{Script=Han}/u)
  const kept = await page.evaluate(() => [localStorage.length, sessionStorage.length])
  expect(kept).toEqual([0, 0])
  await new RacePage(page).open()
  await expect(page.locator('html')).toHaveAttribute('lang', 'en')
})

test('nothing is opened that the browser keeps, and the history stays as it was', async ({
  page,
}) => {
  test.slow()
  const race = new RacePage(page)
  await race.openAtRest()
  const before = await race.isWall([20, 12])
  await race.drag([[20, 12]])
  await expect
    .poll(() => page.evaluate(() => sessionStorage.getItem('formicarium.session')))
    .not.toBeNull()
  await page.evaluate(() => localStorage.setItem('formicarium.theme', 'dark'))
  await page.evaluate(() => window.formicarium.compare({ planners: ['astar'], seeds: 1 }))
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#lab\/./)
  const kept = await page.evaluate(() => location.hash)
  const drawn = await page.evaluate(() => sessionStorage.getItem('formicarium.session'))

  const embedded = await openEmbedded(page)
  expect(await embedded.isWall([20, 12])).toBe(before)
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'light')
  const entries = await page.evaluate(() => history.length)
  await page.evaluate(() => window.formicarium.compare({ planners: ['astar'], seeds: 1 }))
  await page.evaluate(() => window.formicarium.load('S..\n.#.\n..G\n'))
  expect(await page.evaluate(() => [history.length, location.hash])).toEqual([entries, ''])
  expect(await page.evaluate(() => sessionStorage.getItem('formicarium.session'))).toBe(drawn)

  await page.goto('about:blank')
  await page.goto(`./?embed${kept}`)
  await expect(page.getByTestId('lab-nothing')).toBeVisible()
  await expect(page.getByTestId('builder')).toHaveCount(0)
  const counted = await page.evaluate(async () => {
    const open = indexedDB.open('formicarium.lab')
    await new Promise((resolve) => {
      open.onsuccess = resolve
    })
    const all = open.result.transaction('studies').objectStore('studies').count()
    return new Promise((resolve) => {
      all.onsuccess = () => resolve(all.result)
    })
  })
  expect(counted, 'the one of the page itself').toBe(1)
})

test('a link that cannot be read is said, and no other race stands in its place', async ({
  page,
}) => {
  await page.goto('./?embed#x=rubbish')
  await expect(page.getByTestId('embed-nothing')).toBeVisible()
  await expect(page.getByTestId('panel-1')).toHaveCount(0)
  await expect(page.getByTestId('full-page')).toBeVisible()
  await expectClean(page, 'a damaged link')
})

test('the mark opens the race of now in a page of its own', async ({ page, context }) => {
  const race = await openEmbedded(page)
  await page.evaluate(() => window.formicarium.load('S....\n.###.\n....G\n'))
  await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
  const before = await race.session()
  const mark = page.getByTestId('full-page')
  await expect(mark).toHaveAttribute('rel', 'noopener')
  await mark.hover()
  await expect(mark).toHaveAttribute('href', /\/#x=.+/)
  const [opened] = await Promise.all([context.waitForEvent('page'), mark.click()])
  const other = new RacePage(opened)
  await other.ready()
  expect(new URL(opened.url()).search).toBe('')
  await expect(opened.getByTestId('share')).toBeVisible()
  await expect(opened.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
  expect((await other.session()).scenario).toEqual(before.scenario)
})

test('ants walk at once where the address says so', async ({ page }) => {
  const race = await openEmbedded(page, '?embed&autoplay')
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
})

const SMALL = documentText({ entries: [{ id: 'ants', planner: 'ant-system' }], seeds: 6 })

test('a comparison has its results without the builder, and runs', async ({ page }) => {
  test.slow()
  const whole = new ComparisonPage(page)
  await whole.open()
  await whole.script({ document: SMALL })
  await page.getByTestId('lab-share').click()
  const field = page.getByTestId('lab-share-link')
  await expect(field).toHaveValue(/#q=/)
  await page.getByTestId('embed-open').click()
  await expect(page.getByTestId('embed-html')).toHaveValue(/\?embed#q=/)
  await expect(page.getByTestId('embed-control-play')).toHaveCount(0)
  const fragment = new URL(await field.inputValue()).hash
  await page.goto('about:blank')
  await page.goto(`./?embed${fragment}`)
  await expect(page.getByTestId('run-bar')).toBeVisible()
  for (const absent of ['lab-back', 'lab-share', 'lab-change', 'builder', 'view-race'])
    await expect(page.getByTestId(absent)).toHaveCount(0)
  await expectClean(page, 'a comparison in a frame')
  await page.getByTestId('lab-go-on').click()
  await expect.poll(() => whole.phase()).toBe('done')
  await expect(page.getByTestId('toast-info')).toContainText('nothing is kept')
  const mark = page.getByTestId('full-page')
  await mark.hover()
  await expect(mark).toHaveAttribute('href', /\/#q=.+/)
  await page.setViewportSize({ width: 600, height: 400 })
  await expectClean(page, 'a small frame')
})

test('the share dialog has the line to paste, with the controls that are chosen', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('share').click()
  await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
  await page.getByTestId('embed-open').click()
  const html = page.getByTestId('embed-html')
  await expect(html).toHaveValue(/^<iframe src="http[^"]*\/\?embed#x=[^"]+" title="[^"]+"/)
  await page.getByTestId('embed-control-step').uncheck()
  await page.getByTestId('embed-control-charts').check()
  await page.getByTestId('embed-height').fill('600')
  await page.getByTestId('embed-height').blur()
  await expect(html).toHaveValue(/\?embed=play,numbers,charts#x=[^>]* height="600"/)
  await expectClean(page, 'the share dialog')
  const src = /src="([^"]+)"/.exec(await html.inputValue())?.[1] ?? ''
  const before = await race.session()
  await page.goto('about:blank')
  await page.goto(src.replaceAll('&amp;', '&'))
  await expect(page.getByTestId('panel-1')).toBeVisible()
  expect((await race.session()).scenario).toEqual(before.scenario)
})

test('the keyboard alone runs a race and reaches the mark', async ({ page }) => {
  const race = await openEmbedded(page)
  await page.keyboard.press('Shift+ArrowRight')
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  for (let at = 0; at < 20; at++) {
    await page.keyboard.press('Tab')
    if (await page.getByTestId('full-page').evaluate((mark) => mark === document.activeElement))
      return
  }
  throw new Error('the mark was not reached')
})

for (const look of ['?embed', '?embed=play,step,numbers,layers,edit,charts&theme=dark'])
  test(`axe finds nothing serious in ${look}`, async ({ page }) => {
    await page.setViewportSize({ width: 900, height: 560 })
    await openEmbedded(page, look)
    await expectClean(page, 'at rest')
    await page.getByTestId('play').click()
    await page.getByTestId('play').click()
    await expectClean(page, 'paused')
  })

test('on a phone it fits, and axe finds nothing serious @phone', async ({ page }) => {
  await openEmbedded(page, '?embed=play,step,numbers,charts')
  await expect(page.getByTestId('full-page')).toBeInViewport()
  const { scrollWidth, clientWidth } = await page.evaluate(() => document.documentElement)
  expect(scrollWidth).toBe(clientWidth)
  await expectClean(page, 'phone')
})
