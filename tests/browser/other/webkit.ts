/**
 * WebKitGTK's own browser by its own driver, on a screen of its own that nobody sees.
 * Its driver takes touches for a mouse: the finger is a pen, the nearest that it can do.
 */
import { mkdir, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { expect } from '@playwright/test'
import type { Point, Race } from '../race'
import type { Finger } from '../stroke'
import { DrivenRace } from './driven_race'
import type { OtherBrowser } from './other_browser'
import { freePort, Program } from './programs'
import { type Action, WebDriverSession } from './webdriver'

/** The window's own bar is wider than a phone; without letters and borders it is narrow. */
const NARROW_BAR =
  '* { font-size: 1px; min-width: 0; min-height: 0; margin: 0; padding: 0; border-width: 0; }'

/** A run to its end is one script. */
const CAPABILITIES = { timeouts: { script: 120_000 } }

export class WebKit implements OtherBrowser {
  readonly pointerType = 'pen'
  readonly race: Race
  readonly finger: Finger

  private constructor(
    private readonly screen: Program,
    private readonly driver: Program,
    private readonly session: WebDriverSession,
    site: string,
  ) {
    this.race = new WebKitRace(session, site)
    this.finger = new Pen(session)
  }

  get name(): string {
    const { browserName, browserVersion } = this.session.capabilities
    return `WebKitGTK ${browserVersion} (${browserName})`
  }

  /** The settings of the window go into a folder that may be lost. */
  static async start(program: string, site: string, settings: string): Promise<WebKit> {
    await mkdir(join(settings, 'gtk-3.0'), { recursive: true })
    await writeFile(join(settings, 'gtk-3.0/gtk.css'), NARROW_BAR)
    const screen = await Program.start('Xvfb', ['-displayfd', '1', '-screen', '0', '1600x1200x24'])
    const display = () => /^\d+$/m.exec(screen.output())?.[0]
    await expect.poll(display, 'Xvfb tells its display').toBeDefined()
    const port = await freePort()
    const driver = await Program.start(program, [`--port=${port}`], {
      DISPLAY: `:${display()}`,
      GDK_BACKEND: 'x11',
      XDG_CONFIG_HOME: settings,
      // Where no graphics card is, pictures shared with one take twenty times as long.
      WEBKIT_DISABLE_DMABUF_RENDERER: '1',
    })
    const server = `http://127.0.0.1:${port}`
    await expect.poll(() => answers(server, driver), 'the driver answers').toBe(true)
    const session = await WebDriverSession.begin(server, CAPABILITIES)
    return new WebKit(screen, driver, session, site)
  }

  /** Sizes of windows count the bar: it is measured and added. */
  async resize(width: number, height: number): Promise<void> {
    const view = () => this.race.ask(() => [innerWidth, innerHeight] as const)
    await this.session.resizeWindow(width, height)
    await expect.poll(async () => (await view())[0]).toBe(width)
    const bar = height - (await view())[1]
    await this.session.resizeWindow(width, height + bar)
    await expect.poll(view).toEqual([width, height])
  }

  async close(): Promise<void> {
    await this.session.end()
    await this.driver.end()
    await this.screen.end()
  }
}

async function answers(server: string, driver: Program): Promise<boolean> {
  // An error where it has ended.
  driver.output()
  try {
    return (await fetch(`${server}/status`)).ok
  } catch {
    return false
  }
}

class WebKitRace extends DrivenRace {
  constructor(
    private readonly driven: WebDriverSession,
    site: string,
  ) {
    super(site)
  }

  go(address: string): Promise<void> {
    return this.driven.go(address)
  }

  /** Tried again while it is not there yet or something lies over it. */
  press(testId: string): Promise<void> {
    const control = `[data-testid="${testId}"]`
    return expect(async () => {
      await this.evaluate(toSight, control)
      await this.driven.click(control)
    }).toPass()
  }

  leave(): Promise<void> {
    return this.driven.point('mouse', [moveTo({ x: 0, y: 0 })])
  }

  evaluate<R, A>(what: (argument: A) => R | Promise<R>, argument: A): Promise<R> {
    return this.driven.execute(`return (${what})(arguments[0])`, argument)
  }
}

/** On the page: the driver does not scroll to what is in sight by a part, and clicks on its middle. */
const toSight = (selector: string) =>
  document.querySelector(selector)?.scrollIntoView({ block: 'nearest' })

class Pen implements Finger {
  constructor(private readonly session: WebDriverSession) {}

  down(point: Point): Promise<void> {
    return this.session.point('pen', [moveTo(point), { type: 'pointerDown', button: 0 }])
  }

  move(point: Point): Promise<void> {
    return this.session.point('pen', [moveTo(point)])
  }

  up(): Promise<void> {
    return this.session.point('pen', [{ type: 'pointerUp', button: 0 }])
  }
}

const moveTo = ({ x, y }: Point): Action => ({
  type: 'pointerMove',
  x: Math.round(x),
  y: Math.round(y),
  duration: 0,
})
