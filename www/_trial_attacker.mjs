import { chromium } from '@playwright/test'
export const U = 'http://localhost:4621/'
const tests = {}
const only = process.argv.slice(2)
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium' })
export async function fresh(opts = {}, url = U) {
  const ctx = await browser.newContext({ viewport: { width: 1440, height: 900 }, permissions: ['clipboard-read', 'clipboard-write'], ...opts })
  const page = await ctx.newPage()
  page.errs = []
  page.on('pageerror', (e) => { page.errs.push('PAGEERR ' + e.message) })
  page.on('console', (m) => { if (m.type() === 'error' || m.type() === 'warning') page.errs.push(m.type() + ' ' + m.text()) })
  page.on('dialog', (d) => { page.errs.push('DIALOG ' + d.type() + d.message()); d.accept().catch(()=>{}) })
  if (opts.before) await opts.before(page)
  if (url) { await page.goto(url); await ready(page) }
  return page
}
export async function ready(page) {
  await page.getByTestId('play').waitFor()
  await page.waitForFunction(() => { const a = window.formicarium?.session() && window.formicarium.results(); return a?.every((o) => o.summary !== null) }, null, { timeout: 30000 })
}
export const phase = (page) => page.getByTestId('play').getAttribute('data-phase')
export const run = (page, n) => page.evaluate((n) => window.formicarium.run(n == null ? undefined : { iterations: n }).then(() => 1, (e) => 'ERR ' + e.kind + ' ' + e.message), n)
export const res = (page) => page.evaluate(() => window.formicarium.results().map((r) => ({ p: r.planner, it: r.summary?.iteration, st: r.summary?.status, len: r.summary?.metrics?.length, ch: r.summary?.changes, dig: r.summary?.digest, path: r.path, v: r.verified, h: r.history.length })))
export const brief = async (page) => (await res(page)).map(({ path, ...r }) => ({ ...r, n: path?.length }))
export const sess = (page) => page.evaluate(() => { const s = window.formicarium.session(); return { ...s, scenario: { ...s.scenario, cells: Array.from(s.scenario.cells), heights: null } } })
export async function pt(page, [x, y], place = 1) {
  const b = await page.getByTestId(`panel-${place}`).locator('.stage').boundingBox()
  const s = await sess(page); const { width: w, height: h } = s.scenario.spec
  // whole map fits: use scale as placement: min with margins - approximated
  const sc = Math.min((b.width) / w, (b.height) / h) 
  const k = await page.evaluate(() => 0)
  return { x: b.x + b.width / 2 + (x + 0.5 - w / 2) * sc * 0.97, y: b.y + b.height / 2 + (y + 0.5 - h / 2) * sc * 0.97 }
}
export async function stroke(page, cells, place = 1, hold) {
  const p = []
  for (const c of cells) p.push(await pt(page, c, place))
  await page.mouse.move(p[0].x, p[0].y); await page.mouse.down()
  for (const q of p.slice(1)) await page.mouse.move(q.x, q.y)
  if (hold) await hold()
  await page.mouse.up(); await page.evaluate(() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r))))
}
/** does the path cross a wall of the session's present map */
export async function crossing(page) {
  const s = await sess(page); const w = s.scenario.spec.width
  return (await res(page)).map((r) => (r.path ?? []).filter(([x, y]) => s.scenario.cells[y * w + x] === 1))
}
export async function toasts(page) { return page.locator('[data-testid^=toast]').allInnerTexts() }
export async function link(page) {
  await page.getByTestId('share').click(); const f = page.getByTestId('share-link')
  await page.waitForFunction(() => /#x=/.test(document.querySelector('[data-testid=share-link]')?.value ?? ''), null, { timeout: 8000 })
  const v = await f.inputValue(); await page.keyboard.press('Escape'); await page.locator('dialog[open]').waitFor({ state: 'detached' }).catch(() => {}); return v
}
/** opens the link in a fresh context and tells the verification */
export async function verify(l, n = 2) {
  const p = await fresh({}, l)
  await p.waitForTimeout(2500)
  const out = (await brief(p)).map(({ p, v }) => p + ':' + v)
  const errs = p.errs.slice(0, 4), t = await toasts(p)
  await p.context().close(); return { out, errs, t }
}
export const keep = (page) => page.getByTestId('keep-trails').selectOption('keep')
export const shot = (page, n) => page.screenshot({ path: `/tmp/trial-attacker/${n}.png` })
const mod = await import(process.env.T ?? '/tmp/trial-attacker/t.mjs')
for (const [n, f] of Object.entries(mod.default)) {
  if (only.length && !only.includes(n)) continue
  try { console.log('##', n); await Promise.race([f({ fresh, ready, phase, run, res, brief, sess, pt, stroke, crossing, toasts, link, verify, keep, shot, browser, U }), new Promise((_, j) => setTimeout(() => j(new Error('TIMEOUT 90s')), 90000))]) } catch (e) { console.log('  !!', n, e.message.slice(0, 600)) }
}
await browser.close()
process.exit(0)
