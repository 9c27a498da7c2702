import { gzipSync } from 'node:zlib'
import { expect, test } from '@playwright/test'
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

test.describe('hosting', () => {
  test('runs below any path @subpath', async ({ page }) => {
    const lab = new Lab(page)
    await lab.open()
    expect(new URL(page.url()).pathname.length).toBeGreaterThan(1)
    await expect.poll(() => lab.antMoves()).toBeGreaterThan(0)
  })
})
