// A first visit with nothing in the cache: from the address to the first step of a planner.

/** On the page: marks the first answer of a worker that has made a step. */
function markFirstStep() {
  window.Worker = class extends Worker {
    constructor(...given) {
      super(...given)
      performance.mark('worker')
      this.addEventListener('message', ({ data }) => {
        const { ant_moves = 0, cell_expansions = 0 } = data.summary?.effort ?? {}
        performance.mark(`answer ${data.kind ?? data.id}`)
        if (ant_moves + cell_expansions > 0) performance.mark('first step')
      })
    }
  }
}

/** Seconds until then, of the page's own thread slowed down so many times. */
export async function opening(browser, address, throttling) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } })
  const page = await context.newPage()
  await page.addInitScript(markFirstStep)
  const session = await context.newCDPSession(page)
  await session.send('Network.clearBrowserCache')
  await session.send('Emulation.setCPUThrottlingRate', { rate: throttling })
  await page.goto(address)
  await page.waitForFunction(() => performance.getEntriesByName('first step').length > 0)
  const entries = await page.evaluate(() =>
    performance
      .getEntries()
      .map(({ name, startTime, responseEnd }) => [name, startTime, responseEnd]),
  )
  await context.close()
  const [, at] = entries.find(([name]) => name === 'first step')
  return { seconds: at / 1000, entries }
}
