// A first visit with nothing in the cache: from the address to the first step of a planner and its first iteration, and the page's longest
// task meanwhile.

/** What Lighthouse calls slow 4G: bytes a second, and milliseconds from a request to its answer. */
const NETWORKS = {
  'slow-4g': { downloadThroughput: 1.6e6 / 8, uploadThroughput: 0.75e6 / 8, latency: 150 },
}

/** The longest task counts so long after the first iteration: what comes when the page rests is part of the visit. */
const AFTER_MS = 3000

/** On the page: marks the first answers of a worker that has made a step, and an iteration; keeps the longest task. */
function markFirstSteps() {
  const once = (name) => performance.getEntriesByName(name).length === 0 && performance.mark(name)
  window.Worker = class extends Worker {
    constructor(...given) {
      super(...given)
      once('worker')
      this.addEventListener('message', ({ data }) => {
        const { iteration = 0, effort = {} } = data.summary ?? {}
        const { ant_moves = 0, cell_expansions = 0 } = effort
        if (ant_moves + cell_expansions > 0) once('first step')
        if (ant_moves > 0 && iteration > 0) once('first iteration')
      })
    }
  }
  window.longest = 0
  const keep = (list) => {
    for (const { duration } of list.getEntries())
      window.longest = Math.max(window.longest, duration)
  }
  new PerformanceObserver(keep).observe({ type: 'longtask', buffered: true })
}

/** Seconds until then, with the page's own thread slowed down so many times, over a network of `NETWORKS` if one is named. */
export async function opening(browser, address, { throttling, network }) {
  const context = await browser.newContext({
    viewport: { width: 1440, height: 900 },
    serviceWorkers: 'block',
  })
  const page = await context.newPage()
  await page.addInitScript(markFirstSteps)
  const session = await context.newCDPSession(page)
  await session.send('Network.enable')
  await session.send('Network.clearBrowserCache')
  if (network)
    await session.send('Network.emulateNetworkConditions', { offline: false, ...NETWORKS[network] })
  await session.send('Emulation.setCPUThrottlingRate', { rate: throttling })
  await page.goto(address, { waitUntil: 'commit' })
  await page.waitForFunction(() => performance.getEntriesByName('first iteration').length > 0)
  await page.waitForTimeout(AFTER_MS)
  const seconds = (name) =>
    page.evaluate((mark) => performance.getEntriesByName(mark)[0].startTime / 1000, name)
  const answer = {
    seconds: await seconds('first step'),
    iteration: await seconds('first iteration'),
    task: await page.evaluate(() => window.longest / 1000),
  }
  await context.close()
  return answer
}
