/** Browsers name their language in ways that are no language tag: the page works all the same. */
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

/** How many pixels of the convergence chart are drawn upon. */
const inked = (page: Page) =>
  page
    .getByTestId('chart')
    .locator('canvas')
    .evaluate((canvas: HTMLCanvasElement) => {
      const context = canvas.getContext('2d')
      const { data } = context?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] }
      let count = 0
      for (let at = 3; at < data.length; at += 4) if (data[at] !== 0) count++
      return count
    })

for (const language of ['C', 'en-US@posix', '', 'de-DE']) {
  test(`the chart is drawn where the browser calls its language "${language}"`, async ({
    page,
  }) => {
    const complaints: string[] = []
    page.on('pageerror', (error) => complaints.push(error.message))
    await page.addInitScript((name) => {
      Object.defineProperty(navigator, 'language', { get: () => name })
      Object.defineProperty(navigator, 'languages', { get: () => [name] })
    }, language)
    await new RacePage(page).openAtRest()
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    await expect.poll(() => inked(page)).toBeGreaterThan(200)
    expect(await page.locator('html').getAttribute('lang')).toBe('en')
    expect(complaints).toEqual([])
  })
}

for (const [language, lang] of [
  ['zh-CN', 'zh-CN'],
  ['zh_CN.UTF-8', 'zh-CN'],
  ['zhx', 'en'],
]) {
  test(`"${language}" opens the page in ${lang}`, async ({ page }) => {
    await page.addInitScript((name) => {
      Object.defineProperty(navigator, 'language', { get: () => name })
    }, language)
    await new RacePage(page).open()
    await expect(page.locator('html')).toHaveAttribute('lang', `${lang}`)
  })
}
