/** Page object of the race: what specs do there more than once. */
import { type Browser, type CDPSession, expect, type Locator, type Page } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { dropFiles } from './dropped_files'
import { type Point, Race, runsAreLoaded } from './race'
import { drawn } from './workers'

/** CSS pixels. */
const CORNER = 12

export class RacePage extends Race {
  constructor(readonly page: Page) {
    super()
  }

  async open(address = './'): Promise<void> {
    await this.page.goto('about:blank')
    await this.page.goto(address)
    await this.ready()
  }

  async ready(): Promise<void> {
    await expect(this.page.getByTestId('play')).toBeVisible()
    await this.page.waitForFunction(runsAreLoaded)
  }

  override async openAtRest(address = './'): Promise<void> {
    await super.openAtRest(address)
    await expect(this.page.getByTestId('play')).toHaveAccessibleName(/play/i)
  }

  press(testId: string): Promise<void> {
    return this.page.getByTestId(testId).click()
  }

  leave(): Promise<void> {
    return this.page.mouse.move(0, 0)
  }

  evaluate<R, A>(what: (argument: A) => R | Promise<R>, argument: A): Promise<R> {
    return this.page.evaluate<R, A>(what as never, argument)
  }

  /** A picture of a panel, without its rounded corners, whose shades vary from time to time. */
  async shot(place = 1): Promise<Buffer> {
    const stage = this.stage(place)
    await stage.scrollIntoViewIfNeeded()
    const box = await stage.boundingBox()
    if (!box) throw new Error('the stage is not on screen')
    const clip = {
      x: box.x + CORNER,
      y: box.y + CORNER,
      width: box.width - 2 * CORNER,
      height: box.height - 2 * CORNER,
    }
    return this.page.screenshot({ clip })
  }

  /** A panel's picture once it no longer changes: workers draw a moment after they have answered. */
  async picture(place = 1): Promise<Buffer> {
    await drawn(this.page)
    let last = await this.shot(place)
    const rests = async () => {
      const before = last
      last = await this.shot(place)
      return before.equals(last)
    }
    await expect.poll(rests, { intervals: [200] }).toBe(true)
    return last
  }

  /** Waits until a panel's picture differs from what it was; with a `cause`, from the one that was at rest before it. */
  async seesMotion(place = 1, cause?: () => Promise<unknown>): Promise<void> {
    const before = cause ? await this.picture(place) : await this.shot(place)
    await cause?.()
    const changed = async () => !before.equals(await this.shot(place))
    await expect.poll(changed, { intervals: [50] }).toBe(true)
  }

  /** The field of a parameter of the selected panel; those that planners share are folded away. */
  async param(key: string): Promise<Locator> {
    const field = this.page.getByTestId(`param-${key}`)
    const more = this.page.getByTestId('more-parameters')
    await expect(more).toBeVisible()
    if (!(await field.isVisible())) await more.click()
    return field
  }

  stage(place = 1): Locator {
    return this.page.getByTestId(`panel-${place}`).locator('.stage')
  }

  /** Drags the mouse along cells, in few steps: the page must fill in what lies between. */
  async drag(cells: Cell[], place = 1): Promise<void> {
    const points = await Promise.all(cells.map((cell) => this.pointOf(cell, place)))
    const [first, ...rest] = points
    if (!first) return
    await this.page.mouse.move(first.x, first.y)
    await this.page.mouse.down()
    for (const { x, y } of rest) await this.page.mouse.move(x, y)
    await this.page.mouse.up()
    await this.frame()
  }

  /**
   * Prints how much processor time the page's own thread takes per frame: scripts, style, layout and painting
   * together. A number to read, not to pass: it depends on the machine and on what else it does.
   */
  async reportPageThread(what: string): Promise<void> {
    const cdp = await this.page.context().newCDPSession(this.page)
    await cdp.send('Performance.enable', { timeDomain: 'threadTicks' })
    const busy = async () => {
      const { metrics } = await cdp.send('Performance.getMetrics')
      return 1000 * (metrics.find(({ name }) => name === 'TaskDuration')?.value ?? 0)
    }
    const perFrame: number[] = []
    for (let sample = 0; sample < 40; sample++) {
      const before = await busy()
      for (let frame = 0; frame < 3; frame++) await this.frame()
      perFrame.push(((await busy()) - before) / 6)
    }
    perFrame.sort((a, b) => a - b)
    expect(perFrame[0]).toBeGreaterThan(0)
    const [median, worst] = [perFrame[perFrame.length >> 1], perFrame.at(-1)]
    console.log(
      `page thread, ${what}: median ${median?.toFixed(2)} ms a frame, worst ${worst?.toFixed(2)} ms`,
    )
  }

  /** Downloads the map in a format of the export dialog. */
  async exported(format: string): Promise<{ name: string; bytes: Buffer }> {
    const { page } = this
    await this.menu('map-menu', 'open-export')
    await page.getByTestId(`export-${format}`).click()
    await expect(page.getByTestId('export-download')).toBeEnabled()
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId('export-download').click(),
    ])
    const chunks: Buffer[] = []
    for await (const chunk of await download.createReadStream()) chunks.push(Buffer.from(chunk))
    await this.leaveDialog()
    return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) }
  }

  async importByButton(name: string, content: string | Buffer): Promise<void> {
    await this.menu('map-menu', 'open-import')
    const file = { name, mimeType: 'application/octet-stream', buffer: Buffer.from(content) }
    await this.page.getByTestId('import-file').setInputFiles(file)
  }

  drop(name: string, content: string | Buffer): Promise<void> {
    return this.dropTogether([[name, content]])
  }

  /** Drops several files at once. */
  async dropTogether(files: [name: string, content: string | Buffer][]): Promise<void> {
    await dropFiles(this.page, 'main', files)
  }

  async paste(content: string): Promise<void> {
    await this.page.evaluate((text) => {
      const data = new DataTransfer()
      data.setData('text/plain', text)
      document.body.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }),
      )
    }, content)
  }

  /** The share link as the dialog shows it. */
  async shareLink(): Promise<string> {
    await this.page.getByTestId('share').click()
    const field = this.page.getByTestId('share-link')
    await expect(field).toHaveValue(/#x=/)
    const link = await field.inputValue()
    await this.leaveDialog()
    return link
  }

  /** Applies what the dialog of size, moves and robot says; it looks at quantities first, and closes when they fit. */
  async applyRules(): Promise<void> {
    await this.press('resize')
    await expect(this.page.getByTestId('resize-dialog')).toBeHidden()
  }

  /** Waits until an open dialog is gone: until then keys do not reach the page. */
  async leaveDialog(): Promise<void> {
    await expect(this.page.locator('dialog')).toBeVisible()
    await this.page.keyboard.press('Escape')
    await expect(this.page.locator('dialog')).toHaveCount(0)
  }

  async setSpeed(index: number): Promise<void> {
    await this.page.getByTestId('speed').fill(String(index))
  }
}

/** Touches with several fingers, which Playwright does not offer. */
export class Fingers {
  private constructor(private readonly session: CDPSession) {}

  static async on(page: Page): Promise<Fingers> {
    return new Fingers(await page.context().newCDPSession(page))
  }

  async down(...points: Point[]): Promise<void> {
    await this.send('touchStart', points)
  }

  async move(...points: Point[]): Promise<void> {
    await this.send('touchMove', points)
  }

  async up(): Promise<void> {
    await this.send('touchEnd', [])
  }

  private async send(
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    points: Point[],
  ): Promise<void> {
    const touchPoints = points.map((point, id) => ({ ...point, id }))
    await this.session.send('Input.dispatchTouchEvent', { type, touchPoints })
  }
}

/** The race in a browser context of its own, which shares nothing with the first. */
export async function freshRace(browser: Browser, address: string): Promise<RacePage> {
  const race = new RacePage(await (await browser.newContext()).newPage())
  await race.open(address)
  return race
}
