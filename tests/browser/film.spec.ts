/** Films of a race: drawn frame by frame from copies of its runs, the same whenever they are made. */
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { FilmPage, type Saved, seek, shownAlone } from './film_page'
import { drawnPixels, textOfCode } from './qr_reader'

const SMALL = { width: 320, height: 240 }
/** Of a race of twelve iterations at six a second: its run, two seconds of result, four of the code. */
const FRAMES = 2 * 24 + 1 + 6 * 24 - 1

/** By its path: Playwright loads packages that it finds by name as CommonJS. */
const reader = (): Promise<typeof import('mediabunny')> =>
  import(join(__dirname, '../../www/node_modules/mediabunny/dist/bundles/mediabunny.mjs'))

/** What a reader of video files finds in it. */
async function read({ bytes }: Saved) {
  const { ALL_FORMATS, BlobSource, EncodedPacketSink, Input } = await reader()
  const input = new Input({
    formats: ALL_FORMATS,
    source: new BlobSource(new Blob([new Uint8Array(bytes)])),
  })
  const track = await input.getPrimaryVideoTrack()
  if (!track) throw new Error('there is no video in the file')
  let frames = 0
  for await (const _ of new EncodedPacketSink(track).packets()) frames++
  const { title = '', comment = '' } = await input.getMetadataTags()
  const [width, height] = [await track.getDisplayWidth(), await track.getDisplayHeight()]
  return { frames, width, height, duration: await input.computeDuration(), title, comment }
}

/** Pixels that are of the colour of the first panel's path. */
async function coloured(page: Page): Promise<number> {
  const { pixels } = await drawnPixels(page, 'video')
  const bytes = Buffer.from(pixels, 'base64')
  let count = 0
  for (let i = 0; i < bytes.length; i += 4) {
    const [red = 0, green = 0, blue = 0] = bytes.subarray(i, i + 3)
    if (Math.abs(red - 0xd5) < 24 && Math.abs(green - 0x58) < 24 && blue < 48) count++
  }
  return count
}

async function smallFilm(page: Page, iterations = 12): Promise<FilmPage> {
  const film = await FilmPage.open(page, iterations)
  await film.size(SMALL.width, SMALL.height)
  await page.getByTestId('film-rate').selectOption('24')
  await page.getByTestId('film-layer').selectOption('none')
  await film.fill({ speed: iterations / 2 })
  return film
}

test('a film has the frames that were told, its link, and ends with the best paths', async ({
  page,
}) => {
  const film = await smallFilm(page)
  const link = await linkOf(film)
  await expect(page.getByTestId('film-status')).toContainText(`${FRAMES} frames, 8 s`)
  const ready = await film.make()
  await expect(ready).toHaveAttribute('data-agreement', 'same')
  const saved = await film.save()
  const found = await read(saved)
  console.log(`${saved.name}: ${Math.ceil(saved.bytes.length / 1000)} kB`)
  expect(found).toMatchObject({ ...SMALL, frames: FRAMES, title: 'Two corridors' })
  expect(found.duration).toBeCloseTo(FRAMES / 24, 3)
  expect(found.comment).toContain(link)

  const alone = await shownAlone(page, saved, `video/${saved.name.split('.').at(-1)}`, 'video')
  const video = await alone.locator('video').evaluate((shown) => {
    const { videoWidth, videoHeight, duration } = shown as HTMLVideoElement
    return { videoWidth, videoHeight, duration }
  })
  expect(video).toMatchObject({ videoWidth: SMALL.width, videoHeight: SMALL.height })
  expect(video.duration).toBeCloseTo(FRAMES / 24, 1)
  await seek(alone, 0.02)
  const before = await coloured(alone)
  await seek(alone, 3)
  expect(await coloured(alone)).toBeGreaterThan(3 * before)
})

/** The link of the race, as the share dialog has it. */
async function linkOf(film: FilmPage): Promise<string> {
  await film.race.leaveDialog()
  const link = await film.race.shareLink()
  await film.openDialog()
  await film.size(SMALL.width, SMALL.height)
  await film.page.getByTestId('film-rate').selectOption('24')
  await film.page.getByTestId('film-layer').selectOption('none')
  await film.fill({ speed: 6 })
  return link
}

test('the last frames carry the link as a code, which survives the encoding', async ({ page }) => {
  const film = await FilmPage.open(page)
  await film.race.leaveDialog()
  const link = await film.race.shareLink()
  await film.openDialog()
  await page.getByTestId('film-rate').selectOption('24')
  await film.fill({ seconds: 7 })
  await film.make()
  const saved = await film.save()
  const alone = await shownAlone(page, saved, `video/${saved.name.split('.').at(-1)}`, 'video')
  await seek(alone, 6.5)
  expect(textOfCode(await drawnPixels(alone, 'video'))).toBe(link)
})

test('the same moments are the same pixels, whether they are looked at or filmed', async ({
  page,
}) => {
  const film = await smallFilm(page)
  await page.getByTestId('film-layer').selectOption('trail')
  await film.drawn()
  const first = await film.canvas()
  await page.getByTestId('film-final').click()
  await film.drawn()
  const last = await film.canvas()
  expect(last).not.toBe(first)
  for (let time = 0; time < 2; time++) {
    await film.make()
    expect(await film.canvas()).toBe(last)
    await page.getByTestId('film-again').click()
    await film.drawn()
  }
})

test('ants walk in a film of moves', async ({ page }) => {
  const film = await smallFilm(page)
  await page.getByTestId('film-unit').selectOption('move')
  await film.fill({ last: 24, speed: 12 })
  await page.getByTestId('film-final').click()
  await film.drawn()
  const last = await film.canvas()
  await film.fill({ last: 20 })
  await film.drawn()
  expect(await film.canvas()).not.toBe(last)
  await film.fill({ last: 24 })
  await film.drawn()
  expect(await film.canvas()).toBe(last)
  const ready = await film.make()
  expect((await read(await film.save())).frames).toBe(2 * 24 + 6 * 24)
  // Twelve iterations are more than 24 moves.
  await expect(ready).toHaveAttribute('data-agreement', 'unknown')
})

test('the race on the page is left alone, and goes on meanwhile', async ({ page }) => {
  const film = await smallFilm(page)
  const before = await film.race.results()
  await film.make()
  expect(await film.race.results()).toEqual(before)
  await film.race.leaveDialog()
  await film.race.press('play')
  await film.openDialog()
  const moves = await film.race.antMoves()
  await film.size(SMALL.width, SMALL.height)
  await film.fill({ seconds: 7 })
  await expect(await film.make()).toHaveAttribute('data-agreement', 'same')
  expect(await film.race.antMoves()).toBeGreaterThan(moves)
})

test('a film goes on where nothing is painted, as in a hidden tab', async ({ page }) => {
  const film = await smallFilm(page)
  await film.fill({ seconds: 7 })
  await film.drawn()
  await page.evaluate(() => {
    window.requestAnimationFrame = () => 0
  })
  await expect(await film.make()).toHaveAttribute('data-agreement', 'same')
})

test('a film that is given up leaves nothing', async ({ page }) => {
  const film = await smallFilm(page)
  await film.drawn()
  const workers = page.workers().length
  await film.fill({ seconds: 120 })
  await film.drawn()
  await film.race.press('film-make')
  await expect(page.getByTestId('film-progress')).toContainText('Frame')
  await film.race.press('film-stop')
  await expect(page.getByTestId('film-make')).toBeVisible()
  await expect(page.getByTestId('film-save')).toHaveCount(0)
  await film.drawn()
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(workers)
  await film.race.press('film-make')
  await film.race.leaveDialog()
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(workers)
})

test('a copy that ends otherwise than the run is said to', async ({ page }) => {
  await page.addInitScript(() => {
    const Plain = Worker
    const lying = { now: false }
    Object.assign(window, { lying })
    window.Worker = class extends Plain {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options)
        this.addEventListener('message', ({ data }) => {
          if (lying.now && data?.kind === 'frame') data.summary.digest = '0000000000000000'
        })
      }
    }
  })
  const film = await smallFilm(page)
  await page.evaluate(() => {
    ;(window as unknown as { lying: { now: boolean } }).lying.now = true
  })
  await film.fill({ seconds: 7 })
  const ready = await film.make()
  await expect(ready).toHaveAttribute('data-agreement', 'differs')
  await expect(ready).toContainText('do not end as the runs on the page')
})

test('a browser without encoders says so, and makes steps all the same', async ({ page }) => {
  await page.addInitScript(() => {
    Reflect.deleteProperty(window, 'VideoEncoder')
  })
  const film = await FilmPage.open(page)
  await expect(page.getByTestId('film-refusal')).toContainText('no encoder')
  await expect(page.getByTestId('film-make')).toBeDisabled()
  await page.getByTestId('film-steps').click()
  await film.fill({ count: 4 })
  await film.make()
  expect((await film.save()).name).toMatch(/\.svg$/)
})

test('WebM where the browser encodes no H.264', async ({ page }) => {
  await page.addInitScript(() => {
    const asked = VideoEncoder.isConfigSupported.bind(VideoEncoder)
    VideoEncoder.isConfigSupported = (config) =>
      config.codec.startsWith('avc') ? Promise.resolve({ supported: false, config }) : asked(config)
  })
  const film = await smallFilm(page)
  await film.fill({ seconds: 7 })
  await expect(page.getByTestId('film-status')).toContainText('WebM')
  await film.make()
  const saved = await film.save()
  expect(saved.name).toMatch(/\.webm$/)
  expect(await read(saved)).toMatchObject({ ...SMALL, frames: 7 * 24 })
  await shownAlone(page, saved, 'video/webm', 'video')
})

test('the page opens the race of its own film', async ({ page }) => {
  const film = await smallFilm(page)
  await film.fill({ seconds: 7 })
  await film.make()
  const { name, bytes } = await film.save()
  const before = await film.race.results()
  await film.race.leaveDialog()
  await film.race.menu('map-menu', 'gallery-maze')
  await film.race.drop(name, bytes)
  await film.race.ready()
  await expect(page.getByTestId('map-menu')).toContainText('Two corridors')
  await page.evaluate(() => window.formicarium.run({ iterations: 12 }))
  const after = await film.race.results()
  expect(after.map(({ summary }) => summary?.digest)).toEqual(
    before.map(({ summary }) => summary?.digest),
  )
})

test('the dialog is clean, by keys alone, in both themes', async ({ page }) => {
  const film = await FilmPage.open(page)
  await expectClean(page, 'film')
  await page.getByTestId('film-slides').click()
  await expectClean(page, 'slides')
  await page.emulateMedia({ colorScheme: 'dark' })
  await expectClean(page, 'slides, dark')
  await page.getByTestId('film-film').focus()
  await page.keyboard.press('Enter')
  await film.size(SMALL.width, SMALL.height)
  await film.fill({ seconds: 7 })
  await page.getByTestId('film-make').focus()
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('film-ready')).toBeVisible({ timeout: 60_000 })
  await expectClean(page, 'ready')
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('film-dialog')).toHaveCount(0)
})
