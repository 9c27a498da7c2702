// Draws the icons of public/ from icon.svg: `node icons.mjs` in www/, with the browser of the tests.
import { readFileSync, writeFileSync } from 'node:fs'
import { chromium } from '@playwright/test'

const svg = readFileSync(new URL('public/icon.svg', import.meta.url), 'utf8')
/** Systems cut maskable icons to their own shape: what matters is in the middle, the ground goes to the edges. */
const maskable = svg
  .replace('rx="7" ', '')
  .replace('<g stroke', '<g transform="translate(4.2 4.2) scale(.7)"><g stroke')
  .replace('</svg>', '</g></svg>')

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium' })
for (const [name, size, drawing] of [
  ['icon-192', 192, svg],
  ['icon-512', 512, svg],
  ['icon-maskable-512', 512, maskable],
]) {
  const page = await browser.newPage({ viewport: { width: size, height: size } })
  await page.setContent(`<style>body{margin:0}svg{display:block;width:${size}px;height:${size}px}</style>${drawing}`)
  writeFileSync(new URL(`public/${name}.png`, import.meta.url), await page.screenshot({ omitBackground: true }))
  await page.close()
}
await browser.close()
