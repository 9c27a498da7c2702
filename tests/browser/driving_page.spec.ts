/** How a path is to drive: smooth curves and energy set, measured, drawn, and kept in links and files. */
import { readFileSync } from 'node:fs'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { FilmPage } from './film_page'
import { freshRace, RacePage } from './race_page'

const MEASURES = ['turning', 'largestCurvature', 'smoothness', 'energy']

/** Twelve by eight cells of half a metre, with a wall from above between the ends. */
const ROOM = {
  format: 'formicarium/scenario@1',
  name: 'room',
  width: 12,
  height: 8,
  resolution: 0.5,
  start: [1, 1],
  goals: [{ at: [10, 1] }],
  map: {
    rows: Array.from({ length: 8 }, (_, y) => (y < 5 ? '.....@......' : '............')),
  },
}

/** The room at rest, with two searches in it: A* by steps, and the polylines of Theta*. */
async function openRoom(page: Page, vehicle?: object): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  const map = JSON.stringify({ ...ROOM, ...(vehicle && { vehicle }) })
  await race.evaluate((text) => window.formicarium.load(text), map)
  await page.getByTestId('planner-1').selectOption('theta-star')
  await page.getByTestId('planner-2').selectOption('astar')
  await race.ready()
  return race
}

async function openFields(race: RacePage): Promise<void> {
  await race.menu('map-menu', 'open-resize')
  await expect(race.page.getByTestId('energy-fields')).toBeVisible()
}

async function apply(page: Page): Promise<void> {
  await new RacePage(page).applyRules()
}

async function finish(race: RacePage): Promise<void> {
  await race.ready()
  await race.page.getByTestId('run-to-end').click()
  await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
}

const vehicleOf = async (race: RacePage) => (await race.session()).scenario.spec.vehicle

async function cell(page: Page, id: string, place = 1): Promise<number> {
  const field = page.getByTestId(`metric-${id}-${place}`)
  await expect(field).toHaveAttribute('data-value', /\d/)
  return Number(await field.getAttribute('data-value'))
}

const SMOOTH = { speed: 1, seconds_per_turn: 0, smoothing: { max_curvature: 2 } }

test.describe('smooth curves', () => {
  test('are set by a turning radius, undone, and told beside the paths', async ({ page }) => {
    const race = await openRoom(page)
    const plain = await vehicleOf(race)
    await openFields(race)
    await page.getByTestId('curve-on').click()
    await expect(page.getByTestId('turning-radius')).toHaveValue('0')
    await page.getByTestId('turning-radius').fill('0.5')
    await apply(page)
    expect(await vehicleOf(race)).toEqual({ ...plain, smoothing: { max_curvature: 2 } })
    await finish(race)
    for (const place of [1, 2]) {
      const { summary } = await race.result(place)
      const driving = summary?.metrics?.driving
      expect(driving).toBeDefined()
      expect(await cell(page, 'turning', place)).toBe(driving?.turning)
      expect(await cell(page, 'largestCurvature', place)).toBe(driving?.largest_curvature)
      expect(await cell(page, 'smoothness', place)).toBe(driving?.smoothness)
      expect(await cell(page, 'energy', place)).toBe(driving?.energy)
      // A curve about a wall is shorter than steps, and no tighter than the vehicle.
      expect(await cell(page, 'curveLength', place)).toBeGreaterThan(9)
      expect(await cell(page, 'curveCurvature', place)).toBeLessThanOrEqual(2)
      await expect(page.getByTestId(`metric-curveBound-${place}`)).toHaveText('kept')
    }
    expect(await cell(page, 'curveLength', 2)).toBeLessThan(await cell(page, 'length', 2))

    await openFields(race)
    await expect(page.getByTestId('turning-radius')).toHaveValue('0.5')
    await page.getByTestId('curve-off').click()
    await apply(page)
    expect(await vehicleOf(race)).toEqual(plain)
    await page.getByTestId('undo').click()
    expect((await vehicleOf(race)).smoothing).toEqual({ max_curvature: 2 })
  })

  test('that cannot be wide enough say so', async ({ page }) => {
    const race = await openRoom(page, { ...SMOOTH, smoothing: { max_curvature: 0.1 } })
    await finish(race)
    await expect(page.getByTestId('metric-curveBound-1')).toHaveText('not kept')
    expect(await cell(page, 'curveCurvature')).toBeGreaterThan(0.1)
  })

  test('change no run, and are drawn while paths are', async ({ page }) => {
    const race = await openRoom(page)
    await finish(race)
    const before = await race.result(1)
    await openFields(race)
    await page.getByTestId('curve-on').click()
    await apply(page)
    await finish(race)
    expect((await race.result(1)).summary?.digest).toBe(before.summary?.digest)
    const withCurve = await race.picture()
    await page.getByTestId('undo').click()
    await finish(race)
    const showsCurve = async () => (await race.picture()).equals(withCurve)
    await expect.poll(showsCurve).toBe(false)
    await page.getByTestId('redo').click()
    await finish(race)
    await expect.poll(showsCurve).toBe(true)
  })

  test('lie over the paths of a picture', async ({ page }) => {
    const race = await openRoom(page, SMOOTH)
    await finish(race)
    await race.menu('map-menu', 'open-export')
    await page.getByTestId('export-picture').click()
    const dialog = page.getByTestId('picture-dialog')
    await expect(dialog).toBeVisible()
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId('picture-svg').click(),
    ])
    const svg = readFileSync(await download.path(), 'utf8')
    expect(svg.match(/class="path"/g)?.length).toBe(svg.match(/class="curve"/g)?.length)
    expect(svg).toContain('class="curve"')
  })
})

test.describe('energy', () => {
  test('begins with the coefficients of the engine, and is told by those that were typed', async ({
    page,
  }) => {
    // What the engine's reader writes where a map leaves them out.
    const told = await openRoom(page, { speed: 1, seconds_per_turn: 0, energy: {} })
    const { energy } = await vehicleOf(told)
    const race = await openRoom(page)
    await openFields(race)
    await page.getByTestId('energy-on').click()
    for (const key of ['per_metre', 'per_radian', 'per_metre_up'] as const)
      await expect(page.getByTestId(`energy-${key}`)).toHaveValue(String(energy?.[key]))
    await page.getByTestId('energy-per_metre').fill('100')
    await page.getByTestId('energy-per_radian').fill('0')
    await apply(page)
    expect((await vehicleOf(race)).energy).toEqual({ ...energy, per_metre: 100, per_radian: 0 })
    await finish(race)
    const metres = (await race.result(1)).summary?.metrics?.length_metres ?? Number.NaN
    expect(await cell(page, 'energy')).toBeCloseTo(100 * metres, 6)
    // No curve was asked for.
    await expect(page.getByTestId('metric-curveLength-1')).toBeHidden()
  })

  test('is not told where nothing asks for it', async ({ page }) => {
    const race = await openRoom(page)
    await finish(race)
    await expect(page.getByTestId('metric-turns-1')).toBeVisible()
    for (const id of MEASURES) await expect(page.getByTestId(`metric-${id}-1`)).toBeHidden()
  })

  test('is told of a robot too', async ({ page }) => {
    const race = await openRoom(page)
    await openFields(race)
    await page.getByTestId('robot-round').click()
    await apply(page)
    await finish(race)
    for (const id of MEASURES) await expect(page.getByTestId(`metric-${id}-1`)).toBeVisible()
  })
})

test.describe('steps and films', () => {
  async function openFilm(page: Page, resolution: number): Promise<FilmPage> {
    const film = await FilmPage.open(page, 1)
    await page.keyboard.press('Escape')
    const map = JSON.stringify({ ...ROOM, resolution, vehicle: SMOOTH })
    await film.race.evaluate((text) => window.formicarium.load(text), map)
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await film.openDialog()
    return film
  }

  test('steps have curves and a scale bar', async ({ page }) => {
    const film = await openFilm(page, 0.5)
    await page.getByTestId('film-steps').click()
    // Two maps beside a code leave no room for a bar.
    await page.getByTestId('film-panels').selectOption({ index: 1 })
    await film.fill({ count: 4 })
    await film.make()
    const svg = (await film.save()).bytes.toString()
    expect(svg).toContain('class="curve"')
    expect(svg.match(/class="scale-bar"/g)).toHaveLength(4)
    expect(svg).toMatch(/>[125] m</)
  })

  /** The longest level line that is dark, as a share of the frame's width: the wall is a cell wide, 4 %, a bar of a metre 8 %. */
  const longestLine = (page: Page): Promise<number> =>
    page.getByTestId('film-canvas').evaluate((shown) => {
      const { width, height } = shown as HTMLCanvasElement
      const context = new OffscreenCanvas(width, height).getContext('2d')
      context?.drawImage(shown as HTMLCanvasElement, 0, 0)
      const pixels = context?.getImageData(0, 0, width, height).data ?? []
      let longest = 0
      for (let i = 0, line = 0; 4 * i < pixels.length; i++) {
        const isDark = (pixels[4 * i] ?? 255) < 120 && (pixels[4 * i + 1] ?? 255) < 120
        line = isDark && i % width > 0 ? line + 1 : 0
        longest = Math.max(longest, line)
      }
      return longest / width
    })

  test('a film has a scale bar on maps that have a scale alone', async ({ page }) => {
    await openFilm(page, 0.5)
    expect(await longestLine(page)).toBeGreaterThan(0.055)
    await page.keyboard.press('Escape')
    await openFilm(page, 1)
    expect(await longestLine(page)).toBeLessThan(0.055)
  })
})

test('numbers that the engine does not take are refused in its words', async ({ page }) => {
  const race = await openRoom(page)
  await openFields(race)
  await page.getByTestId('curve-on').click()
  await page.getByTestId('turning-radius').fill('-2')
  await expect(page.getByTestId('driving-wrong')).toContainText(/max_curvature = -0\.5/)
  await expect(page.getByTestId('resize')).toBeDisabled()
  await page.getByTestId('turning-radius').fill('1')
  await page.getByTestId('energy-on').click()
  await page.getByTestId('energy-per_radian').fill('-1')
  await expect(page.getByTestId('driving-wrong')).toContainText(/0 or a positive number/)
  await expect(page.getByTestId('energy-per_radian')).toHaveAttribute('aria-invalid', 'true')
  await expect(page.getByTestId('quantity-wrong')).toBeHidden()
  await expectClean(page, 'Size, moves and robot with a vehicle')
  await page.getByTestId('energy-per_radian').fill('1')
  await expect(page.getByTestId('resize')).toBeEnabled()
})

test('a link keeps what the vehicle says', async ({ page, browser }) => {
  const energy = { per_metre: 3, per_radian: 0.5, per_metre_up: 20 }
  const race = await openRoom(page, { ...SMOOTH, energy })
  await finish(race)
  const told = await vehicleOf(race)
  expect(told).toEqual({ ...SMOOTH, energy })
  const other = await freshRace(browser, await race.shareLink())
  expect(await vehicleOf(other)).toEqual(told)
  await other.page.context().close()
})

test('in Chinese', async ({ page }) => {
  const race = await openRoom(page, SMOOTH)
  await race.menu('language', 'language-zh-CN')
  await finish(race)
  await expect(page.getByTestId('metric-curveBound-1')).toHaveText('满足')
  await openFields(race)
  await expect(page.getByTestId('curve-fields')).toContainText('最小转弯半径（米）')
  await page.getByTestId('energy-on').click()
  await page.getByTestId('energy-per_metre').fill('-1')
  await expect(page.getByTestId('driving-wrong')).toContainText('能耗系数与曲率也可以是 0')
})

test('on a phone @phone', async ({ page }) => {
  const race = await openRoom(page, SMOOTH)
  await openFields(race)
  await page.getByTestId('energy-on').tap()
  const field = await page.getByTestId('energy-per_metre_up').boundingBox()
  expect((field?.x ?? -1) >= 0 && (field?.x ?? 0) + (field?.width ?? 999) <= 390).toBe(true)
  await expectClean(page, 'the vehicle on a phone')
})
