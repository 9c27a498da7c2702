/** The dialog of films, and what comes of it. */
import { readFile } from 'node:fs/promises'
import { expect, type Locator, type Page } from '@playwright/test'
import { RacePage } from './race_page'

export interface Saved {
  name: string
  bytes: Buffer
}

export class FilmPage {
  private constructor(readonly race: RacePage) {}

  get page(): Page {
    return this.race.page
  }

  /** A race that stands at an iteration, with the dialog open. */
  static async open(page: Page, iterations = 12): Promise<FilmPage> {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.evaluate((count) => window.formicarium.run({ iterations: count }), iterations)
    const film = new FilmPage(race)
    await film.openDialog()
    return film
  }

  async openDialog(): Promise<void> {
    await this.race.press('share')
    await this.race.press('share-film')
    await this.drawn()
  }

  /** Waits until the preview shows what has been chosen. */
  async drawn(): Promise<void> {
    await expect(this.page.getByTestId('film-preview')).toHaveAttribute('data-ready', 'true')
  }

  async fill(values: Record<string, number>): Promise<void> {
    for (const [field, value] of Object.entries(values)) {
      const input = this.page.getByTestId(`film-${field}`)
      await input.fill(String(value))
      await input.press('Tab')
    }
  }

  /** An own size, as small as its test can do with. */
  async size(width: number, height: number): Promise<void> {
    await this.page.getByTestId('film-size').selectOption('-1')
    await this.fill({ width, height })
  }

  async make(): Promise<Locator> {
    await this.race.press('film-make')
    const ready = this.page.getByTestId('film-ready')
    await expect(ready).toBeVisible({ timeout: 60_000 })
    return ready
  }

  async save(): Promise<Saved> {
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.race.press('film-save'),
    ])
    return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) }
  }

  /** What stands on the dialog's canvas. */
  canvas(): Promise<string> {
    return this.page
      .getByTestId('film-canvas')
      .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL())
  }
}

/** The file in an element of a page that has no policy of its own. */
export async function shownAlone(
  page: Page,
  { bytes }: Saved,
  type: string,
  element: 'video' | 'img',
): Promise<Page> {
  const other = await page.context().newPage()
  await other.evaluate(
    ([text, kind, name]) => {
      const data = Uint8Array.from(atob(text), (char) => char.charCodeAt(0))
      const shown = document.createElement(name)
      shown.src = URL.createObjectURL(new Blob([data], { type: kind }))
      document.body.append(shown)
      const loaded = name === 'video' ? 'loadeddata' : 'load'
      return new Promise<void>((done, fail) => {
        shown.addEventListener(loaded, () => done())
        shown.addEventListener('error', () => fail(new Error('it cannot be shown')))
      })
    },
    [bytes.toString('base64'), type, element] as const,
  )
  return other
}

/** Takes a film to a second of it. */
export function seek(page: Page, seconds: number): Promise<void> {
  return page.locator('video').evaluate((video, to) => {
    const shown = video as HTMLVideoElement
    return new Promise<void>((done) => {
      shown.addEventListener('seeked', () => requestAnimationFrame(() => done()), { once: true })
      shown.currentTime = to
    })
  }, seconds)
}
