import { gzipSync } from 'node:zlib'
import { expect, type Page, test } from '@playwright/test'
import { unpack } from '../../www/src/share/codec'
import { open } from '../../www/src/share/envelope'
import { RacePage } from './race_page'
import { countCalls, ticks } from './workers'

/** A planner that only the whole engine has. */
const LATER = 'option[value="max-min-ant-system"]'

/** Opens the page and tells when ants took their first step, in milliseconds since 1970. */
async function firstStep(page: Page): Promise<number> {
  // The search counts each expanded cell, and ants step together with it: its first cell is their first step.
  await page.addInitScript(() => {
    const watch = setInterval(() => {
      const results = window.formicarium?.results() ?? []
      if (!results.some(({ summary }) => summary && summary.effort.cell_expansions > 0)) return
      clearInterval(watch)
      performance.mark('first-step')
    }, 10)
  })
  await page.goto('./')
  const step = () =>
    page.evaluate(() => {
      const [mark] = performance.getEntriesByName('first-step')
      return mark && performance.timeOrigin + mark.startTime
    })
  await expect.poll(step).toBeDefined()
  return (await step()) ?? Number.NaN
}

test.describe('opening', () => {
  test('ants walk within two seconds, without a click', async ({ page }) => {
    const race = new RacePage(page)
    const walked = await firstStep(page)
    const took = walked - (await page.evaluate(() => performance.timeOrigin))
    console.log(`first step ${Math.round(took)} ms after the address was entered`)
    expect(took).toBeLessThan(2000)
    await race.seesMotion()
    await expect(page.getByTestId('panel-1')).toBeVisible()
    await expect(page.getByTestId('panel-2')).toBeVisible()
  })

  test('nothing is reported to the console as an error', async ({ page }) => {
    const complaints: string[] = []
    page.on('pageerror', (error) => complaints.push(error.message))
    page.on('console', (message) => {
      if (message.type() === 'error') complaints.push(message.text())
    })
    const race = new RacePage(page)
    await race.open()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await expect(page.getByTestId('planner-1').locator(LATER)).toBeAttached()
    await page.waitForTimeout(1000)
    expect(complaints).toEqual([])
  })

  test('ants and search differ, and the optimum is proven beside them', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.setSpeed(8)
    await page.getByTestId('play').click()
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    await expect
      .poll(async () => (await race.result(1)).summary?.metrics?.length ?? 0)
      .toBeGreaterThan(0)
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /\d/)
    const optimum = Number(await page.getByTestId('optimum').getAttribute('data-value'))
    const [ants, search] = await race.results()
    expect(search?.summary?.metrics?.length).toBeCloseTo(optimum, 9)
    expect(ants?.summary?.metrics?.length ?? 0).toBeGreaterThanOrEqual(optimum - 1e-9)
  })

  test('under reduced motion it waits for the first key or click', async ({ page }) => {
    await countCalls(page)
    await page.emulateMedia({ reducedMotion: 'reduce' })
    const race = new RacePage(page)
    await race.open()
    await page.waitForTimeout(700)
    expect(await ticks(page)).toBe(0)
    await page.keyboard.press('Shift')
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('what must arrive before ants walk stays under 195 KB compressed', async ({ page }) => {
    const arrived: { file: string; asked: number; bytes: number }[] = []
    page.on('requestfinished', async (request) => {
      const body = await (await request.response())?.body()
      const file = new URL(request.url()).pathname
      const asked = request.timing().startTime
      arrived.push({ file, asked, bytes: gzipSync(body ?? '').length })
    })
    const walked = await firstStep(page)
    await expect(page.getByTestId('planner-1').locator(LATER)).toBeAttached()
    const engines = () => arrived.map(({ file }) => file).filter((file) => file.endsWith('.wasm'))
    await expect.poll(() => engines().length).toBeGreaterThan(1)
    await page.waitForTimeout(3000)

    const before = sizes(arrived.filter(({ asked }) => asked <= walked))
    const all = sizes(arrived)
    console.log(`first load: ${inWords(before)}; a few seconds later: ${inWords(all)}`)
    for (const [file, bytes] of before) console.log(`  ${(bytes / 1024).toFixed(1)} KB ${file}`)
    expect(total(before)).toBeLessThan(195 * 1024)
    // Once before ants walk, once when the browser is idle: neither build of the engine comes twice.
    expect([engines().length, new Set(engines()).size]).toEqual([2, 2])
    expect([...before.keys()].filter((file) => file.endsWith('.wasm'))).toHaveLength(1)
  })
})

/** Bytes by file; a file that several workers ask for is sent once, and then comes from the browser's own store. */
function sizes(arrived: { file: string; bytes: number }[]): Map<string, number> {
  return new Map(arrived.map(({ file, bytes }) => [file, bytes]))
}

const total = (files: Map<string, number>) =>
  [...files.values()].reduce((sum, bytes) => sum + bytes, 0)

const inWords = (files: Map<string, number>) =>
  `${(total(files) / 1024).toFixed(1)} KB gzipped in ${files.size} files`

test.describe('a reload', () => {
  const kept = (page: Page) => page.evaluate(() => sessionStorage.getItem('formicarium.session'))
  /** How fast what was kept plays; undefined while nothing is kept. */
  const keptSpeed = async (page: Page) => {
    const [, fragment] = (await kept(page))?.split('#x=') ?? []
    const noGenerator = () => Promise.reject(new Error('no generator here'))
    return fragment && (await unpack(await open(fragment), noGenerator)).speed
  }

  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('keeps the drawn map, the planners and the settings, until one starts over', async ({
    page,
  }) => {
    const race = new RacePage(page)
    const first = await race.session()
    await race.drag([
      [4, 19],
      [9, 19],
    ])
    await race.menu('add-panel', 'add-dijkstra')
    await page.getByTestId('parameters-1').click()
    await page.getByTestId('param-ants').fill('23')
    await page.getByTestId('param-ants').press('Enter')
    await page.getByTestId('seed').fill('77')
    await page.getByTestId('seed').press('Enter')
    await race.setSpeed(1)
    const before = await race.session()
    // All of it is written together, so what was changed last tells for the rest.
    await expect.poll(() => keptSpeed(page)).toBe(1)
    await page.reload()
    await race.ready()
    const after = await race.session()
    expect(after.scenario).toEqual(before.scenario)
    expect([after.seed, after.speed]).toEqual([77, 1])
    expect(after.panels.map(({ planner, params }) => [planner, params])).toEqual(
      before.panels.map(({ planner, params }) => [planner, params]),
    )
    await expect(page.getByTestId('verified-1')).toBeHidden()

    await race.menu('map-menu', 'start-over')
    await race.ready()
    expect((await race.session()).scenario).toEqual(first.scenario)
    await expect.poll(() => kept(page)).toBeNull()
    await page.reload()
    await race.ready()
    expect((await race.session()).scenario).toEqual(first.scenario)
  })

  test('keeps the tick of a gallery map, and undo brings it back', async ({ page }) => {
    const race = new RacePage(page)
    const tick = page.getByTestId('gallery-open-field')
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.drag([[20, 12]])
    await expect(tick).toHaveAttribute('aria-checked', 'false')
    await page.getByTestId('undo').click()
    await expect(tick).toHaveAttribute('aria-checked', 'true')
    await expect.poll(() => kept(page)).toContain('open-field#x=')
    await page.reload()
    await race.ready()
    await expect(tick).toHaveAttribute('aria-checked', 'true')
  })

  test('with a link in the address opens the link', async ({ page }) => {
    const race = new RacePage(page)
    const link = await race.shareLink()
    const walls = await race.walls()
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => kept(page)).toContain('open-field')
    await race.open(link)
    expect(await race.walls()).toBe(walls)
  })

  test('something unreadable that was kept is passed over in silence', async ({ page }) => {
    // As the page opens: what is open now would be kept in its place.
    await page.addInitScript(() => sessionStorage.setItem('formicarium.session', '#x=rubbish'))
    await page.reload()
    await new RacePage(page).ready()
    await expect(page.getByTestId('toast-error')).toBeHidden()
    await expect.poll(() => kept(page)).toBeNull()
  })
})

test('a large map plays by iterations, unless the reader has set the speed', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const speed = page.getByTestId('speed')
  const generate = async (side: string) => {
    await race.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-width').fill(side)
    await page.getByTestId('generate-height').fill(side)
    await page.getByTestId('generate').click()
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(Number(side))
  }
  await generate('160')
  await expect(speed).toHaveAttribute('aria-valuetext', '1 iteration / frame')
  await page.getByTestId('undo').click()
  await expect(speed).toHaveAttribute('aria-valuetext', '4 moves / frame')
  await race.setSpeed(2)
  await generate('150')
  await expect(speed).toHaveAttribute('aria-valuetext', '1 move / frame')
})

test.describe('hosting', () => {
  test('runs below any path @subpath', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    expect(new URL(page.url()).pathname.length).toBeGreaterThan(1)
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })
})
