/** Firefox as it is installed, driven by Puppeteer over WebDriver BiDi, with real touches. */
import { type Browser, launch, type Page, type TouchHandle } from 'puppeteer-core'
import type { Point, Race } from '../race'
import type { Finger } from '../stroke'
import { DrivenRace } from './driven_race'
import type { OtherBrowser } from './other_browser'

/** As phones tell it: the only pointer is a finger, which cannot hover. */
const FINGERS_ONLY = { 'ui.primaryPointerCapabilities': 1, 'ui.allPointerCapabilities': 1 }

export class Firefox implements OtherBrowser {
  readonly pointerType = 'touch'
  readonly race: Race
  readonly finger: Finger

  private constructor(
    private readonly browser: Browser,
    readonly name: string,
    private readonly page: Page,
    site: string,
  ) {
    this.race = new FirefoxRace(page, site)
    this.finger = new Touch(page)
  }

  static async start(program: string, site: string): Promise<Firefox> {
    const browser = await launch({
      browser: 'firefox',
      executablePath: program,
      headless: true,
      extraPrefsFirefox: FINGERS_ONLY,
    })
    return new Firefox(browser, await browser.version(), await browser.newPage(), site)
  }

  resize(width: number, height: number): Promise<void> {
    return this.page.setViewport({ width, height, deviceScaleFactor: 3, hasTouch: true })
  }

  close(): Promise<void> {
    return this.browser.close()
  }
}

class FirefoxRace extends DrivenRace {
  constructor(
    private readonly page: Page,
    site: string,
  ) {
    super(site)
  }

  async go(address: string): Promise<void> {
    await this.page.goto(address)
  }

  press(testId: string): Promise<void> {
    return this.page.locator(`[data-testid="${testId}"]`).click()
  }

  leave(): Promise<void> {
    return this.page.mouse.move(0, 0)
  }

  evaluate<R, A>(what: (argument: A) => R | Promise<R>, argument: A): Promise<R> {
    return this.page.evaluate(what as (argument: unknown) => R | Promise<R>, argument)
  }
}

class Touch implements Finger {
  private touch: TouchHandle | null = null

  constructor(private readonly page: Page) {}

  async down({ x, y }: Point): Promise<void> {
    this.touch = await this.page.touchscreen.touchStart(x, y)
  }

  async move({ x, y }: Point): Promise<void> {
    await this.touch?.move(x, y)
  }

  async up(): Promise<void> {
    await this.touch?.end()
  }
}
