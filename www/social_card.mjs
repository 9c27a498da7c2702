// Draws public/social.png, the card of a link, from the built page itself: `node social_card.mjs`, in www. docs/hosting.md says what it is for.
import { writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from '@playwright/test'
import { preview } from 'vite'

const SIZE = { width: 1200, height: 630 }
const ITERATIONS = 12

const here = dirname(fileURLToPath(import.meta.url))
const server = await preview({ root: here, preview: { port: 0 }, logLevel: 'error' })
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium',
})
// The page's policy would refuse the styles of the card.
const page = await browser.newPage({
  viewport: { width: 1800, height: 900 },
  colorScheme: 'light',
  bypassCSP: true,
})
await page.goto(server.resolvedUrls.local[0])
await page.getByTestId('reset').click()
await page.evaluate((iterations) => window.formicarium.run({ iterations }), ITERATIONS)
const panel = await page.getByTestId('panel-1').locator('canvas').first().screenshot()
const icon = await page.locator('link[rel=icon]').getAttribute('href')

await page.setViewportSize(SIZE)
await page.addStyleTag({
  content: `
    body { background: #12483a; color: #fff; font-size: 30px; }
    #card { display: grid; grid-template-columns: 500px 1fr; height: 630px; align-items: center; }
    #card div { padding: 0 40px 0 64px; }
    #card h1 { margin: 24px 0 12px; font-size: 66px; line-height: 1; }
    #card p { margin: 0; line-height: 1.35; opacity: 0.85; }
    #card .icon { width: 92px; height: 92px; border: 2px solid #fff4; border-radius: 24px; }
    #card .panel { width: 700px; height: 630px; object-fit: none; background: #f4f6f5; }`,
})
await page.evaluate(
  ([iconAddress, panelAddress]) => {
    const words = document.querySelector('meta[name=description]').content
    document.body.innerHTML = `<main id="card">
      <div><img class="icon" src="${iconAddress}"><h1>Formicarium</h1><p>${words}</p></div>
      <img class="panel" src="${panelAddress}"></main>`
  },
  [icon, `data:image/png;base64,${panel.toString('base64')}`],
)
await page.evaluate(() => Promise.all([...document.images].map((image) => image.decode())))
writeFileSync(join(here, 'public/social.png'), await page.screenshot())
await browser.close()
await server.close()
