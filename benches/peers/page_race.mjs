// A race that plays, and the time from an input to the picture that shows it, in every panel.

/** Inputs come so far apart that one has been shown before the next. */
const APART_MS = 400
const VIEWPORT = { width: 1440, height: 900 }
/** Of the wheel; about 1.6 times larger. */
const CLOSER = -300

/** On the page: notes inputs, and stamps what workers are asked. */
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

/** In a worker: notes, from now on, when what it was asked has been drawn. It draws in its own frames, or before the next of them. */
function stampFrames() {
  const isNew = !self.shown
  self.shown = []
  if (!isNew) return
  self.addEventListener('message', ({ data: { kind, askedAt } }) => {
    if (kind === 'tick') return
    requestAnimationFrame(() =>
      self.shown.push({ askedAt, at: performance.timeOrigin + performance.now() }),
    )
  })
}

/** Plays, wherever the race stands, until every panel has made some iterations. */
async function playsOn(page) {
  const play = page.getByTestId('play')
  if ((await play.getAttribute('data-phase')) !== 'running') await play.click()
  await page.waitForFunction(() =>
    window.formicarium.results().every(({ summary }) => summary?.iteration > 2),
  )
}

export class PlayingRace {
  /** Opens a map (JSON, as `formicarium` writes it) with these planners, and plays. */
  static async open(browser, address, map, planners) {
    const page = await browser.newPage({ viewport: VIEWPORT })
    await page.addInitScript(stampRequests)
    await page.goto(address)
    await page.waitForFunction(() => window.formicarium?.session())
    await page.evaluate(
      async ([map, planners]) => {
        window.formicarium.pause()
        await window.formicarium.load(map)
        const session = window.formicarium.session()
        const params = { iterations: 100_000 }
        session.panels = planners.map((planner) => ({
          planner,
          preset: null,
          params,
          result: null,
        }))
        await window.formicarium.load(session)
      },
      [map, planners],
    )
    await playsOn(page)
    return new PlayingRace(page)
  }

  constructor(page) {
    this.page = page
  }

  /**
   * Seconds from one input until the last panel has drawn it, until the first has, and how many iterations the slowest panel made in
   * a second around it.
   */
  async input(kind, seed) {
    const { page } = this
    const stage = await page.locator('[data-testid="panel-1"] .stage').boundingBox()
    const at = { x: stage.x + stage.width / 2 + 3 * (seed % 7), y: stage.y + stage.height / 2 }
    await page.mouse.move(at.x, at.y)
    if (kind === 'pan') {
      await this.#wheel(CLOSER)
      await page.mouse.down({ button: 'middle' })
    }
    await page.waitForTimeout(APART_MS)
    const [before, began] = [await this.#iterations(), performance.now()]
    await this.#forget()
    await this.#do(kind, at, seed)
    await page.waitForTimeout(APART_MS)
    const made = (await this.#iterations()) - before
    const passed = (performance.now() - began) / 1000
    const answer = await this.#shown()
    await this.#undo(kind)
    return kind === 'press' ? answer : { ...answer, iterations: made / passed }
  }

  async #do(kind, { x, y }, seed) {
    if (kind === 'hover' || kind === 'pan') await this.page.mouse.move(x + 40, y + 30)
    if (kind === 'press') await this.page.mouse.down()
    if (kind === 'zoom') await this.#wheel(seed % 2 === 0 ? -CLOSER : CLOSER)
  }

  async #undo(kind) {
    const { mouse, keyboard } = this.page
    if (kind === 'pan') {
      await mouse.up({ button: 'middle' })
      await this.#wheel(-CLOSER)
    }
    if (kind === 'press') {
      await mouse.up()
      await keyboard.press('Control+z')
      // A wall begins the runs anew.
      await playsOn(this.page)
    }
  }

  async #wheel(pixels) {
    await this.page.keyboard.down('Control')
    await this.page.mouse.wheel(0, pixels)
    await this.page.keyboard.up('Control')
  }

  async #shown() {
    const frames = await this.#inWorkers(() => self.shown ?? [])
    const [input] = await this.page.evaluate(() => window.inputs)
    const firsts = frames.flatMap((all) => all.find(({ askedAt }) => askedAt >= input) ?? [])
    const times = firsts.map(({ at }) => (at - input) / 1000)
    return { seconds: Math.max(...times), first: Math.min(...times) }
  }

  async #forget() {
    await this.#inWorkers(stampFrames)
    await this.page.evaluate(() => {
      window.inputs = []
    })
  }

  /** Panels may get other workers in between. */
  async #inWorkers(what) {
    const all = this.page.workers().map((worker) => worker.evaluate(what).catch(() => null))
    return (await Promise.all(all)).filter((answer) => answer !== null && answer !== undefined)
  }

  /** Finished iterations of the slowest panel. */
  #iterations() {
    return this.page.evaluate(() =>
      Math.min(...window.formicarium.results().map(({ summary }) => summary?.iteration ?? 0)),
    )
  }
}
