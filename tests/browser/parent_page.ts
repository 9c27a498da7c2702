/** A page of somebody else's, on a server of its own, with ours in a frame. */
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { expect, type Frame, type FrameLocator, type Page, test } from '@playwright/test'

/** A server of its own, of another site than ours: browsers take the two for strangers. It gives the same HTML at every address. */
export class Course {
  html = ''
  private readonly server = createServer((_, answer) => {
    answer.setHeader('content-type', 'text/html')
    answer.end(this.html)
  })

  static async open(): Promise<Course> {
    const course = new Course()
    await new Promise<void>((resolve) => course.server.listen(0, '127.0.0.1', resolve))
    return course
  }

  get origin(): string {
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}`
  }

  close(): void {
    this.server.close()
  }
}

/** Where our page is. */
export const home = () => test.info().project.use.baseURL ?? ''

export class ParentPage {
  private constructor(
    readonly page: Page,
    readonly inner: FrameLocator,
  ) {}

  /** `query` and fragment of the frame, such as `?embed#x=…`; `attributes` of the frame beside its address. */
  static async around(
    page: Page,
    course: Course,
    query: string,
    attributes = 'referrerpolicy="origin"',
  ): Promise<ParentPage> {
    const src = `${home()}${query}`.replaceAll('&', '&amp;')
    course.html = `<!doctype html><html lang="en"><title>A course</title><h1>A course</h1>
      <script>
        window.heard = []
        addEventListener('message', ({ origin, data }) => heard.push({ origin, data }))
      </script>
      <iframe src="${src}" title="A race" width="640" height="440" ${attributes}></iframe>`
    await page.goto(`${course.origin}/lecture/`)
    return new ParentPage(page, page.frameLocator('iframe'))
  }

  async frame(): Promise<Frame> {
    const handle = await this.page.locator('iframe').elementHandle()
    const frame = await handle?.contentFrame()
    if (!frame) throw new Error('there is no frame')
    return frame
  }

  /** What the parent has heard, newest last. */
  heard(): Promise<{ origin: string; data: Record<string, unknown> }[]> {
    return this.page.evaluate(() => (window as unknown as { heard: [] }).heard)
  }

  /** Waits until the frame takes requests. */
  async ready(): Promise<void> {
    const events = async () => (await this.heard()).map(({ data }) => data.event)
    await expect.poll(events).toContain('ready')
  }

  /** Sends a message to the frame as it stands. */
  async send(message: unknown): Promise<void> {
    await this.page.evaluate((data) => {
      document.querySelector('iframe')?.contentWindow?.postMessage(data, '*')
    }, message)
  }

  /** What the frame says to a message with this id. */
  async answer(
    message: { id: unknown } & Record<string, unknown>,
  ): Promise<Record<string, unknown>> {
    await this.send(message)
    const find = async () =>
      (await this.heard()).map(({ data }) => data).find(({ id }) => id === message.id)
    await expect.poll(find).toBeDefined()
    return (await find()) ?? {}
  }
}
