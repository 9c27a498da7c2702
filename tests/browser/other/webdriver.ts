/** As much of W3C WebDriver as the checks need: a session with one window. */

/** How elements are named in answers. */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf'

export type Action =
  | { type: 'pointerMove'; x: number; y: number; duration: 0 }
  | { type: 'pointerDown' | 'pointerUp'; button: 0 }

export interface Capabilities {
  browserName: string
  browserVersion: string
}

export class WebDriverSession {
  private constructor(
    private readonly address: string,
    readonly capabilities: Capabilities,
  ) {}

  static async begin(server: string, capabilities: object): Promise<WebDriverSession> {
    const begun = await call<{ sessionId: string; capabilities: Capabilities }>(
      'POST',
      `${server}/session`,
      { capabilities: { alwaysMatch: capabilities } },
    )
    return new WebDriverSession(`${server}/session/${begun.sessionId}`, begun.capabilities)
  }

  async end(): Promise<void> {
    await call('DELETE', this.address)
  }

  async go(url: string): Promise<void> {
    await call('POST', `${this.address}/url`, { url })
  }

  /** Runs the body of a function on the page and waits for what it promises. */
  execute<R>(script: string, ...args: unknown[]): Promise<R> {
    return call('POST', `${this.address}/execute/sync`, { script, args })
  }

  /** Clicks on the middle of an element; an error where something else is hit. */
  async click(selector: string): Promise<void> {
    const query = { using: 'css selector', value: selector }
    const found = await call<Record<string, string>>('POST', `${this.address}/element`, query)
    await call('POST', `${this.address}/element/${found[ELEMENT]}/click`, {})
  }

  /** The pointer with this type stays where it is, pressed or not, until its next actions. */
  async point(pointerType: 'mouse' | 'pen', actions: Action[]): Promise<void> {
    const source = { type: 'pointer', id: pointerType, parameters: { pointerType }, actions }
    await call('POST', `${this.address}/actions`, { actions: [source] })
  }

  async resizeWindow(width: number, height: number): Promise<void> {
    await call('POST', `${this.address}/window/rect`, { width, height })
  }
}

async function call<R>(method: 'POST' | 'DELETE', address: string, body?: object): Promise<R> {
  const answer = await fetch(address, { method, body: body && JSON.stringify(body) })
  const { value } = (await answer.json()) as { value: R & { error?: string; message?: string } }
  if (!answer.ok) throw new Error(`${value.error}: ${value.message}`)
  return value
}
