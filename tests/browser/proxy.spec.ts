/** A proxy that refuses everything stands between the page and the world: nothing that the page does ever reaches it. */
import { once } from 'node:events'
import { createServer, get, type Server, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { chromium, expect, test } from '@playwright/test'
import { RacePage } from './race_page'

/** What Chromium asks for itself, whatever page is open. */
const BROWSERS_OWN =
  /^(http:\/\/)?((update|content-autofill)\.googleapis|accounts\.google)\.com[:/]/

let proxy: Server
let asked: string[]

test.beforeAll(async () => {
  asked = []
  const home = new URL(test.info().project.use.baseURL ?? '').host
  proxy = createServer((request, response) => {
    const { host, pathname, search } = new URL(request.url ?? '', 'http://none/')
    if (host === home) return pass(`http://${home}${pathname}${search}`, response)
    asked.push(request.url ?? '')
    response.writeHead(403).end()
  })
  proxy.on('connect', ({ url = '' }, socket) => {
    asked.push(url)
    socket.end('HTTP/1.1 403 Forbidden\r\n\r\n')
  })
  proxy.listen(0, 'localhost')
  await once(proxy, 'listening')
})
test.afterAll(() => proxy.close())

/** The page's own host alone is let through. */
function pass(url: string, response: ServerResponse): void {
  get(url, (answer) => {
    response.writeHead(answer.statusCode ?? 502, answer.headers)
    answer.pipe(response)
  }).on('error', () => response.writeHead(502).end())
}

test('no request leaves the origin: race, link, dialogs, comparison, a copy for days without a network', async ({
  baseURL,
}) => {
  const { launchOptions } = test.info().project.use
  const browser = await chromium.launch({
    ...launchOptions,
    proxy: {
      server: `http://localhost:${(proxy.address() as AddressInfo).port}`,
      // This machine's own addresses, too.
      bypass: '<-loopback>',
    },
  })
  const page = await browser.newPage({ baseURL, serviceWorkers: 'allow' })
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
  const link = await race.shareLink()
  await page.getByTestId('help').click()
  await expect(page.getByTestId('offline')).toHaveAttribute('data-keeping', 'kept', {
    timeout: 60_000,
  })
  await page.keyboard.press('Escape')
  await page.getByTestId('language').click()
  await page.getByTestId('language-zh-CN').click()
  await race.menu('map-menu', 'gallery-terrain-hills')
  await race.ready()
  await page.evaluate(() => window.formicarium.compare({ planners: ['astar'], seeds: 1 }))
  await page.goto('about:blank')
  await page.goto(link)
  await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
  const foreign = () => asked.filter((url) => !BROWSERS_OWN.test(url))
  expect(foreign()).toEqual([])
  // It would have been heard.
  await page.goto('http://formicarium.example/').catch(() => {})
  expect(foreign().length).toBeGreaterThan(0)
  await browser.close()
})
