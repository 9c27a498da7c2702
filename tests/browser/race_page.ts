/** Page object of the race: what specs do there more than once. */
import { type Browser, type CDPSession, expect, type Locator, type Page } from '@playwright/test'
import type { PanelResult, Scripting } from '../../www/src/app/scripting'
import type { Cell } from '../../www/src/model/cell'
import type { Session } from '../../www/src/model/session'
import { placement } from '../../www/src/model/viewpoint'
import { drawn } from './workers'

declare global {
  interface Window {
    formicarium: Scripting
  }
}

const WHOLE_MAP = { zoom: 1, centreX: 0.5, centreY: 0.5 }

/** CSS pixels. */
const CORNER = 12

export class RacePage {
  constructor(readonly page: Page) {}

  /** Opens the page and waits until every panel's run is loaded. */
  async open(address = './'): Promise<void> {
    await this.page.goto('about:blank')
    await this.page.goto(address)
    await this.ready()
  }

  async ready(): Promise<void> {
    await expect(this.page.getByTestId('play')).toBeVisible()
    await this.page.waitForFunction(() => {
      const all = window.formicarium?.session() && window.formicarium.results()
      return all?.every((one) => one.summary !== null)
    })
  }

  /** Opens the page and brings every run back to its beginning. */
  async openAtRest(address = './'): Promise<void> {
    await this.open(address)
    await this.page.getByTestId('reset').click()
    // No hint of a button stays over the maps.
    await this.page.mouse.move(0, 0)
    await expect(this.page.getByTestId('play')).toHaveAccessibleName(/play/i)
    await expect(this.page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
    // A run that has not been loaded yet has no moves either.
    await this.ready()
    await expect.poll(() => this.antMoves()).toBe(0)
  }

  results(): Promise<PanelResult[]> {
    return this.page.evaluate(() => window.formicarium?.results() ?? [])
  }

  async result(place: number): Promise<PanelResult> {
    const result = (await this.results())[place - 1]
    if (!result) throw new Error(`there is no panel ${place}`)
    return result
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

  /** Moves of the finished iterations. */
  async antMoves(): Promise<number> {
    return (await this.result(1)).summary?.effort.ant_moves ?? 0
  }

  /** The session; cells and heights cross from the page as plain numbers. */
  async session(): Promise<Session> {
    const plain = await this.page.evaluate(() => {
      const session = window.formicarium.session()
      return (
        session && {
          ...session,
          scenario: {
            ...session.scenario,
            cells: Array.from(session.scenario.cells),
            heights: session.scenario.heights && Array.from(session.scenario.heights),
          },
        }
      )
    })
    if (!plain) throw new Error('there is no session')
    const { cells, heights, ...rest } = plain.scenario
    return {
      ...plain,
      scenario: {
        ...rest,
        cells: Uint8Array.from(cells),
        heights: heights && Float32Array.from(heights),
      },
    }
  }

  async isWall([x, y]: Cell): Promise<boolean> {
    const { spec, cells } = (await this.session()).scenario
    return cells[y * spec.width + x] === 1
  }

  async walls(): Promise<number> {
    return (await this.session()).scenario.cells.reduce((sum, cell) => sum + cell, 0)
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

  /** The middle of a cell on the page, while the whole map is in view. */
  async pointOf(cell: Cell, place = 1): Promise<{ x: number; y: number }> {
    // A map that changes its size is drawn with the next frame.
    await this.frame()
    const box = await this.stage(place).boundingBox()
    const dpr = await this.page.evaluate(() => devicePixelRatio)
    if (!box) throw new Error('the stage is not on screen')
    const [width, height] = [Math.round(box.width * dpr), Math.round(box.height * dpr)]
    const { spec } = (await this.session()).scenario
    const { scale, originX, originY } = placement(WHOLE_MAP, { width, height, dpr }, spec)
    return {
      x: box.x + (originX + (cell[0] + 0.5) * scale) / dpr,
      y: box.y + (originY + (cell[1] + 0.5) * scale) / dpr,
    }
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

  /** Lets the page draw and act once. */
  async frame(): Promise<void> {
    await this.page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    )
  }

  async menu(menu: string, item: string): Promise<void> {
    await this.page.getByTestId(menu).click()
    await this.page.getByTestId(item).click()
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
    const plain = files.map(([name, content]) => [name, Buffer.from(content).toString('base64')])
    const transfer = await this.page.evaluateHandle((all) => {
      const data = new DataTransfer()
      for (const [name = '', base64 = ''] of all) {
        const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0))
        data.items.add(new File([bytes], name))
      }
      return data
    }, plain)
    await this.page.dispatchEvent('main', 'drop', { dataTransfer: transfer })
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

  async down(...points: { x: number; y: number }[]): Promise<void> {
    await this.send('touchStart', points)
  }

  async move(...points: { x: number; y: number }[]): Promise<void> {
    await this.send('touchMove', points)
  }

  async up(): Promise<void> {
    await this.send('touchEnd', [])
  }

  private async send(
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    points: { x: number; y: number }[],
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
