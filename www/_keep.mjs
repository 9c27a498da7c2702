import { chromium } from '@playwright/test'
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium' })
for (const [w, h, phone, name, dark] of [[1440, 900, false, 'k-wide', false], [390, 844, true, 'k-phone', true]]) {
const page = await (await browser.newContext({ viewport: { width: w, height: h }, isMobile: phone, hasTouch: phone, colorScheme: dark ? 'dark':'light', deviceScaleFactor: phone ? 2 : 1 })).newPage()
await page.goto('http://localhost:4600/'); await page.getByTestId('play').waitFor(); await page.waitForTimeout(4000)
await page.getByTestId('play').click()
if (!phone) await page.getByTestId('keep-trails').selectOption('keep')
else { await page.evaluate(() => localStorage.setItem('formicarium.keepTrails','keep')); await page.reload(); await page.getByTestId('play').waitFor(); await page.waitForTimeout(4000); await page.getByTestId('play').click() }
await page.getByTestId('reset').click().catch(()=>{})
await page.evaluate(() => window.formicarium.run({ iterations: 12 }))
const box = await page.locator('.stage').first().boundingBox()
await page.keyboard.press('w')
await page.mouse.move(box.x + box.width*0.4, box.y + box.height*0.4); await page.mouse.down(); await page.mouse.move(box.x + box.width*0.4, box.y + box.height*0.6, {steps: 8}); await page.mouse.up()
await page.waitForTimeout(500)
await page.evaluate(() => window.formicarium.run({ iterations: 18 }))
await page.waitForTimeout(1500)
await page.screenshot({ path: `/tmp/look/${name}.png` })
}
await browser.close()
