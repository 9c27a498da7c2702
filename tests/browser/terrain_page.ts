/** Helpers for terrains on the race page. */
import { expect, type Page } from '@playwright/test'
import { RacePage } from './race_page'
import { ASC } from './rasters'

export const dialog = (page: Page) => page.getByTestId('terrain-dialog')

export const scenarioOf = async (race: RacePage) => (await race.session()).scenario

/** Heights bit by bit, no data included. */
export async function expectHeights(race: RacePage, expected: ArrayLike<number>): Promise<void> {
  const { heights } = await scenarioOf(race)
  const same =
    heights?.length === expected.length && heights.every((h, i) => Object.is(h, expected[i]))
  expect(same, `${heights?.slice(0, 40)}`).toBe(true)
}

/** Opens the small grid with default settings. */
export async function openAsc(page: Page, text = ASC): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.paste(text)
  await page.getByTestId('terrain-open').click()
  await expect(dialog(page)).toBeHidden()
  await settledDown(race)
  return race
}

/** Opens a terrain of the gallery, at rest. */
export async function openTerrain(
  page: Page,
  id: 'terrain-hills' | 'terrain-slices',
): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', `gallery-${id}`)
  await expect
    .poll(() => page.evaluate(() => window.formicarium.session()?.scenario.heights?.length ?? 0))
    .toBeGreaterThan(0)
  await page.evaluate(() => window.formicarium.pause())
  await settledDown(race)
  return race
}

/** Waits until the runs are loaded, the maps take keys, and the layout above them is final. */
export async function settledDown(race: RacePage): Promise<void> {
  const { page } = race
  await race.ready()
  await expect(race.stage().locator('canvas')).toHaveCount(1)
  await expect(page.getByTestId('view-solid')).toBeVisible()
  await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /./)
}

declare global {
  interface Window {
    /** What the specs count: drawing calls of WebGL, how long the last pictures took, and the contexts that were made. */
    draws: number
    took: number[]
    contexts: WebGL2RenderingContext[]
  }
}

/** Counts what WebGL is asked to draw, from the page's first script on. */
export async function countDraws(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.draws = 0
    window.took = []
    window.contexts = []
    let began = 0
    const gl = WebGL2RenderingContext.prototype
    const elements = gl.drawElements
    gl.drawElements = function (...args) {
      window.draws++
      began ||= performance.now()
      elements.apply(this, args)
    }
    // A picture is done when it has been copied to its panel.
    const flat = CanvasRenderingContext2D.prototype
    const copy = flat.drawImage as (...args: unknown[]) => void
    flat.drawImage = function (this: CanvasRenderingContext2D, ...args: unknown[]) {
      copy.apply(this, args)
      if (began > 0) window.took.push(performance.now() - began)
      began = 0
    } as typeof flat.drawImage
    const context = HTMLCanvasElement.prototype.getContext as (...args: unknown[]) => unknown
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...args: unknown[]
    ) {
      const made = context.apply(this, args)
      if (made instanceof WebGL2RenderingContext && !window.contexts.includes(made))
        window.contexts.push(made)
      return made
    } as typeof HTMLCanvasElement.prototype.getContext
  })
}

export const lostContexts = (page: Page) =>
  page.evaluate(() => window.contexts.map((context) => context.isContextLost()))

/** How bright a picture of an element is: mean, spread, how many different values of 256, share of dark pixels. */
export async function light(page: Page, png: Buffer) {
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height)
    const context = canvas.getContext('2d')
    if (!context) throw new Error('no 2D canvas')
    context.drawImage(bitmap, 0, 0)
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height)
    const values: number[] = []
    for (let i = 0; i < data.length; i += 4)
      values.push(Math.round(((data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0)) / 3))
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length
    const spread = Math.sqrt(
      values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length,
    )
    return { mean, spread, kinds: new Set(values).size }
  }, png.toString('base64'))
}

export const reliefs = (page: Page) => page.locator('.stage.relief')

/** In three dimensions, and every panel's picture has come to rest. */
export async function openRelief(page: Page): Promise<void> {
  await page.getByTestId('view-solid').click()
  await expect(reliefs(page).first()).toBeVisible()
  await settled(page)
}

/** Waits until nothing has been drawn for longer than the page may put off a picture. */
export async function settled(page: Page): Promise<void> {
  const rests = async () => {
    const { draws, slowest } = await page.evaluate(() => ({
      draws: window.draws,
      slowest: Math.max(0, ...window.took.slice(-6)),
    }))
    await page.waitForTimeout(700 + 9 * slowest)
    return draws > 0 && draws === (await page.evaluate(() => window.draws))
  }
  await expect.poll(rests, { timeout: 30_000 }).toBe(true)
}

/** Share of a panel's canvas that something is drawn on, and a number that tells pictures apart. */
export function picture(page: Page, panel = 0) {
  return page.evaluate((index) => {
    const canvas = document.querySelectorAll('.stage.relief')[index]?.querySelector('canvas')
    const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data
    if (!data) throw new Error('there is no canvas')
    let [drawn, sum] = [0, 0]
    for (let i = 0; i < data.length; i += 4) {
      if ((data[i + 3] ?? 0) > 0) drawn++
      sum = (sum * 31 + (data[i] ?? 0) + 256 * (data[i + 1] ?? 0)) % 1_000_003
    }
    return { drawn: (4 * drawn) / data.length, sum }
  }, panel)
}

/** How opaque the first panel's marks are at a point of the page, 0 to 255. */
export function markAt(page: Page, x: number, y: number) {
  return page.evaluate(
    ([px, py]) => {
      const overlay = document.querySelectorAll<HTMLCanvasElement>('.stage.relief canvas')[1]
      const box = overlay?.getBoundingClientRect()
      const data = overlay
        ?.getContext('2d')
        ?.getImageData((px ?? 0) - (box?.left ?? 0), (py ?? 0) - (box?.top ?? 0), 1, 1).data
      return data?.[3] ?? -1
    },
    [x, y],
  )
}

export async function middleOf(page: Page, panel = 0): Promise<{ x: number; y: number }> {
  const box = await reliefs(page).nth(panel).boundingBox()
  if (!box) throw new Error('the stage is not on screen')
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}
