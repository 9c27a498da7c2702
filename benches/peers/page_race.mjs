// A race that plays, and the time from an input to the picture that shows it, in every panel.

/** Inputs come so far apart that one has been shown before the next. */
const APART_MS = 400
const VIEWPORT = { width: 1440, height: 900 }

/** On the page: says in what it asks its workers when it asked. */
function stampRequests() {
  const post = Worker.prototype.postMessage
  Worker.prototype.postMessage = function (message, ...rest) {
    message.askedAt = performance.timeOrigin + performance.now()
    Reflect.apply(post, this, [message, ...rest])
  }
  window.inputs = []
  for (const kind of ['pointerdown', 'pointermove', 'wheel']) {
    const note = ({ timeStamp }) => window.inputs.push(performance.timeOrigin + timeStamp)
    addEventListener(kind, note, { capture: true })
  }
}

/** In a worker: notes when what it was asked has been drawn. It draws in its own frames, or before the next of them. */
function stampFrames() {
  self.shown = []
  self.steps = 0
  self.addEventListener('message', ({ data: { kind, askedAt } }) => {
    if (kind === 'tick') self.steps++
    else
      requestAnimationFrame(() =>
        self.shown.push({ kind, askedAt, at: performance.timeOrigin + performance.now() }),
      )
  })
}

export class PlayingRace {
  /** Opens a map (JSON, as `formicarium` writes it) with these planners, and plays. */
  static async open(browser, address, map, planners) {
    const page = await browser.newPage({ viewport: VIEWPORT })
    page.on('pageerror', (error) => console.error(error))
    await page.addInitScript(stampRequests)
    await page.goto(address)
    await page.waitForFunction(() => window.formicarium?.session())
    await page.evaluate(
      async ([map, planners]) => {
        window.formicarium.pause()
        await window.formicarium.load(map)
        const session = window.formicarium.session()
        session.panels = planners.map((planner) => ({
          planner,
          preset: null,
          params: { iterations: 100_000 },
          result: null,
        }))
        await window.formicarium.load(session)
      },
      [map, planners],
    )
    await page.getByTestId('play').click()
    await page.waitForFunction(() =>
      window.formicarium.results().every(({ summary }) => summary?.iteration > 2),
    )
    const workers = page.workers()
    await Promise.all(workers.map((worker) => worker.evaluate(stampFrames)))
    return new PlayingRace(page, workers)
  }

  constructor(page, workers) {
    this.page = page
    this.workers = workers
  }

  /** Seconds from one input until the last panel has drawn it, and how many iterations the slowest panel made in a second. */
  async input(kind, seed) {
    const { page } = this
    const stage = await page.locator('[data-testid="panel-1"] .stage').boundingBox()
    const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2]
    await page.mouse.move(x + 3 * (seed % 7), y)
    await page.waitForTimeout(APART_MS)
    await this.#prepare(kind)
    const [before, began] = [await this.#iterations(), performance.now()]
    await this.#forget()
    await this.#do(kind, x, y, seed)
    await page.waitForTimeout(APART_MS)
    const shown = await Promise.all(this.workers.map((worker) => worker.evaluate(() => self.shown)))
    const made = (await this.#iterations()) - before
    const [input] = await page.evaluate(() => window.inputs)
    await this.#undo(kind)
    const times = shown
      .map((frames) => frames.find(({ askedAt }) => askedAt >= input))
      .filter((frame) => frame)
      .map(({ at }) => (at - input) / 1000)
    return {
      seconds: Math.max(...times),
      first: Math.min(...times),
      panels: times.length,
      iterations: (1000 * made) / (performance.now() - began),
    }
  }

  #forget() {
    const forget = () => {
      self.shown = []
    }
    const forgetInputs = () => {
      window.inputs = []
    }
    return Promise.all([
      ...this.workers.map((worker) => worker.evaluate(forget)),
      this.page.evaluate(forgetInputs),
    ])
  }

  async #prepare(kind) {
    if (kind === 'pan') await this.page.mouse.down({ button: 'middle' })
  }

  async #do(kind, x, y, seed) {
    const { mouse } = this.page
    if (kind === 'hover' || kind === 'pan') await mouse.move(x + 40 + (seed % 5), y + 30)
    if (kind === 'press') await mouse.down()
    if (kind === 'zoom') {
      await this.page.keyboard.down('Control')
      await mouse.wheel(0, seed % 2 === 0 ? 300 : -300)
      await this.page.keyboard.up('Control')
    }
  }

  async #undo(kind) {
    if (kind === 'pan') await this.page.mouse.up({ button: 'middle' })
    if (kind === 'press') {
      await this.page.mouse.up()
      await this.page.keyboard.press('Control+z')
      await this.page.waitForTimeout(APART_MS)
    }
  }

  /** Finished iterations of the slowest panel. */
  #iterations() {
    return this.page.evaluate(() =>
      Math.min(...window.formicarium.results().map(({ summary }) => summary?.iteration ?? 0)),
    )
  }
}
