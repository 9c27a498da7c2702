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
const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'light' })
await page.goto(server.resolvedUrls.local[0])
await page.getByTestId('reset').click()
await page.evaluate((iterations) => window.formicarium.run({ iterations }), ITERATIONS)
const panel = await page.getByTestId('panel-1').locator('canvas').first().screenshot()
const logo = await page.locator('.brand svg').evaluate((svg) => svg.outerHTML)

await page.setViewportSize(SIZE)
await page.goto('about:blank')
await page.setContent(`
  <style>
    body { margin: 0; background: #12483a; color: #fff; font: 30px/1.35 Figtree, sans-serif; }
    main { display: grid; grid-template-columns: 500px 1fr; height: 630px; align-items: center; }
    div { padding: 0 40px 0 64px; }
    svg { width: 88px; height: 88px; }
    h1 { margin: 24px 0 12px; font-size: 64px; line-height: 1; }
    p { margin: 0; opacity: 0.85; }
    img { width: 700px; height: 630px; object-fit: cover; }
  </style>
  <main>
    <div>${logo}<h1>Formicarium</h1><p>Watch ant colonies plan paths on your own maps, beside exact planners.</p></div>
    <img src="data:image/png;base64,${panel.toString('base64')}">
  </main>`)
await page.locator('img').evaluate((image) => image.decode())
writeFileSync(join(here, 'public/social.png'), await page.screenshot())
await browser.close()
await server.close()
