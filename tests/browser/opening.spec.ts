import { gzipSync } from 'node:zlib'
import { expect, type Page, test } from '@playwright/test'
import { Lab } from './lab'

test.describe('opening', () => {
  test('ants walk within two seconds, without a click', async ({ page }) => {
    const lab = new Lab(page)
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
    const firstStep = () =>
      page.evaluate(() => performance.getEntriesByName('first-step')[0]?.startTime)
    await expect.poll(firstStep).toBeDefined()
    console.log(
      `first step ${Math.round((await firstStep()) ?? 0)} ms after the address was entered`,
    )
    expect(await firstStep()).toBeLessThan(2000)
    await lab.seesMotion()
    await expect(page.getByTestId('panel-1')).toBeVisible()
    await expect(page.getByTestId('panel-2')).toBeVisible()
  })

  test('nothing is reported to the console as an error', async ({ page }) => {
    const complaints: string[] = []
    page.on('pageerror', (error) => complaints.push(error.message))
    page.on('console', (message) => {
      if (message.type() === 'error') complaints.push(message.text())
    })
    await new Lab(page).open()
    await page.waitForTimeout(1000)
    expect(complaints).toEqual([])
  })

  test('ants and search differ, and the optimum is proven beside them', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.setSpeed(8)
    await page.getByTestId('play').click()
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    await expect
      .poll(async () => (await lab.result(1)).summary?.metrics?.length ?? 0)
      .toBeGreaterThan(0)
    const [ants, search] = await lab.results()
    const optimum = Number(await page.getByTestId('optimum').getAttribute('data-value'))
    expect(search?.summary?.metrics?.length).toBeCloseTo(optimum, 9)
    expect(ants?.summary?.metrics?.length ?? 0).toBeGreaterThanOrEqual(optimum - 1e-9)
  })

  test('under reduced motion it waits for the first key or click', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    const lab = new Lab(page)
    await lab.open()
    await page.waitForTimeout(700)
    expect(await lab.antMoves()).toBe(0)
    await page.keyboard.press('Shift')
    await expect.poll(() => lab.antMoves()).toBeGreaterThan(0)
  })

  test('the first load stays under 200 KB compressed', async ({ page }) => {
    const bodies: Promise<[string, number]>[] = []
    page.on('response', (response) => {
      const { pathname } = new URL(response.url())
      bodies.push(response.body().then((body) => [pathname, gzipSync(body).length]))
    })
    await new Lab(page).open()
    const sizes = new Map(await Promise.all(bodies))
    const total = [...sizes.values()].reduce((sum, size) => sum + size, 0)
    console.log(`first load: ${(total / 1024).toFixed(1)} KB gzipped in ${sizes.size} files`)
    expect(total).toBeLessThan(200 * 1024)
  })
})

test.describe('a reload', () => {
  const kept = (page: Page) => page.evaluate(() => sessionStorage.getItem('formicarium.session'))

  test.beforeEach(async ({ page }) => new Lab(page).openAtRest())

  test('keeps the drawn map, the planners and the settings, until one starts over', async ({
    page,
  }) => {
    const lab = new Lab(page)
    const first = await lab.session()
    await lab.drag([
      [4, 19],
      [9, 19],
    ])
    await lab.menu('add-panel', 'add-dijkstra')
    await page.getByTestId('parameters-1').click()
    await page.getByTestId('param-ants').fill('23')
    await page.getByTestId('param-ants').press('Enter')
    await page.getByTestId('seed').fill('77')
    await page.getByTestId('seed').press('Enter')
    await lab.setSpeed(1)
    const before = await lab.session()
    await page.waitForTimeout(1500)
    await page.reload()
    await lab.ready()
    const after = await lab.session()
    expect(after.scenario).toEqual(before.scenario)
    expect([after.seed, after.speed]).toEqual([77, 1])
    expect(after.panels.map(({ planner, params }) => [planner, params])).toEqual(
      before.panels.map(({ planner, params }) => [planner, params]),
    )
    await expect(page.getByTestId('verified-1')).toBeHidden()

    await lab.menu('map-menu', 'start-over')
    await lab.ready()
    expect((await lab.session()).scenario).toEqual(first.scenario)
    await expect.poll(() => kept(page)).toBeNull()
    await page.reload()
    await lab.ready()
    expect((await lab.session()).scenario).toEqual(first.scenario)
  })

  test('keeps the tick of a gallery map, and undo brings it back', async ({ page }) => {
    const lab = new Lab(page)
    const tick = page.getByTestId('gallery-open-field')
    await lab.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => lab.walls()).toBe(0)
    await lab.drag([[20, 12]])
    await expect(tick).toHaveAttribute('aria-checked', 'false')
    await page.getByTestId('undo').click()
    await expect(tick).toHaveAttribute('aria-checked', 'true')
    await expect.poll(() => kept(page)).toContain('open-field#x=')
    await page.reload()
    await lab.ready()
    await expect(tick).toHaveAttribute('aria-checked', 'true')
  })

  test('with a link in the address opens the link', async ({ page }) => {
    const lab = new Lab(page)
    const link = await lab.shareLink()
    const walls = await lab.walls()
    await lab.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => kept(page)).toContain('open-field')
    await lab.open(link)
    expect(await lab.walls()).toBe(walls)
  })

  test('something unreadable that was kept is passed over in silence', async ({ page }) => {
    await page.evaluate(() => sessionStorage.setItem('formicarium.session', '#x=rubbish'))
    await page.reload()
    await new Lab(page).ready()
    await expect(page.getByTestId('toast-error')).toBeHidden()
    await expect.poll(() => kept(page)).toBeNull()
  })
})

test('a large map plays by iterations, unless the reader has set the speed', async ({ page }) => {
  const lab = new Lab(page)
  await lab.openAtRest()
  const speed = page.getByTestId('speed')
  const generate = async (side: string) => {
    await lab.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-width').fill(side)
    await page.getByTestId('generate-height').fill(side)
    await page.getByTestId('generate').click()
    await expect.poll(async () => (await lab.session()).scenario.spec.width).toBe(Number(side))
  }
  await generate('160')
  await expect(speed).toHaveAttribute('aria-valuetext', '1 iteration / frame')
  await page.getByTestId('undo').click()
  await expect(speed).toHaveAttribute('aria-valuetext', '4 moves / frame')
  await lab.setSpeed(2)
  await generate('150')
  await expect(speed).toHaveAttribute('aria-valuetext', '1 move / frame')
})

test.describe('hosting', () => {
  test('runs below any path @subpath', async ({ page }) => {
    const lab = new Lab(page)
    await lab.open()
    expect(new URL(page.url()).pathname.length).toBeGreaterThan(1)
    await expect.poll(() => lab.antMoves()).toBeGreaterThan(0)
  })
})
