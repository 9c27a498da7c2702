/** Room for the map: what share of the window maps get, and that nothing is cut off, at every size. */
import { expect, type Page, test } from '@playwright/test'
import { placement } from '../../www/src/model/viewpoint'
import { RacePage } from './race_page'

const PLANNERS = ['max-min-ant-system', 'ant-colony-system', 'dijkstra', 'theta-star']
const WHOLE_MAP = { zoom: 1, centreX: 0.5, centreY: 0.5 }

/**
 * The least share of the window, in percent, that maps of the opening scenario have in sight: by the number of panels, with the
 * column open (on a compact screen there is none), and for two also with it closed. What was reached, rounded down.
 */
const LEAST: [width: number, height: number, open: Record<number, number>, closed: number][] = [
  [1280, 720, { 1: 45, 2: 28, 4: 34, 6: 32 }, 42],
  [1440, 900, { 1: 45, 2: 26, 4: 38, 6: 29 }, 42],
  [1920, 1080, { 1: 50, 2: 27, 4: 40, 6: 32 }, 43],
  [2560, 1440, { 1: 54, 2: 30, 4: 44, 6: 35 }, 46],
  [768, 1024, { 1: 38, 2: 50, 4: 38, 6: 50 }, 50],
  [390, 844, { 1: 23, 2: 45, 4: 45, 6: 45 }, 45],
]

for (const [width, height, open, closed] of LEAST) {
  test(`at ${width} × ${height} maps have most of the window`, async ({ page }) => {
    await page.setViewportSize({ width, height })
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('remove-2').click()
    for (const count of [1, 2, 4, 6]) {
      await raceWith(race, count)
      const share = await mapShare(race)
      console.log(`${width} × ${height}, ${count} panels: ${share.toFixed(1)} %`)
      expect(share, `${count} panels`).toBeGreaterThanOrEqual(open[count] ?? 100)
      await nothingCutOff(page)
      if (count === 2) {
        const compact = (await page.locator('html').getAttribute('data-compact')) === 'true'
        if (!compact) await page.getByTestId('column').click()
        const whole = await mapShare(race)
        console.log(`${width} × ${height}, two panels alone: ${whole.toFixed(1)} %`)
        expect(whole).toBeGreaterThanOrEqual(closed)
        if (!compact) await page.getByTestId('column').click()
      }
    }
  })
}

/** 1440 × 900 at 200 % is a window of half the size; so are phones held sideways. */
for (const [width, height] of [
  [320, 568],
  [360, 640],
  [640, 400],
  [667, 375],
  [720, 450],
  [844, 390],
  [932, 430],
  [1000, 700],
  [1100, 800],
] as const) {
  test(`at ${width} × ${height} nothing is cut off, and there is a map to see`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height })
    const race = new RacePage(page)
    await race.openAtRest()
    await nothingCutOff(page)
    await raceWith(race, 6)
    await nothingCutOff(page)
    expect(await mapShare(race)).toBeGreaterThan(9)
  })
}

test('long names leave the controls of six panels where they are', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await raceWith(race, 6)
  for (let place = 1; place <= 6; place++)
    await page.getByTestId(`planner-${place}`).selectOption('acost')
  for (const width of [1440, 1280, 1180, 1100, 768, 720]) {
    await page.setViewportSize({ width, height: 800 })
    await race.frame()
    await nothingCutOff(page)
  }
})

test('the column is dragged, moved by keys, closed, and comes back as it was', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const edge = page.getByTestId('column-edge')
  const width = async () => (await page.locator('.column').boundingBox())?.width ?? 0
  const before = await width()
  const box = await edge.boundingBox()
  if (!box) throw new Error('there is no edge')
  await page.mouse.move(box.x + 4, box.y + 200)
  await page.mouse.down()
  await page.mouse.move(box.x - 96, box.y + 220, { steps: 4 })
  await page.mouse.up()
  await expect.poll(width).toBeCloseTo(before + 100, 0)
  await edge.focus()
  await page.keyboard.press('ArrowRight')
  await expect.poll(width).toBeCloseTo(before + 84, 0)
  await page.keyboard.press('c')
  await expect(page.locator('.column')).toBeHidden()
  await page.reload()
  await race.ready()
  await expect(page.locator('.column')).toBeHidden()
  await page.getByTestId('column').click()
  await expect.poll(width).toBeCloseTo(before + 84, 0)
  await edge.dblclick()
  await expect.poll(width).toBeCloseTo(before, 0)
})

test('a part of the column can be folded away, and stays so', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const legend = page.locator('.convergence .plot')
  await expect(legend).toBeVisible()
  await page.getByTestId('fold-convergence').click()
  await expect(legend).toBeHidden()
  await page.reload()
  await race.ready()
  await expect(page.getByTestId('fold-convergence')).toHaveAttribute('aria-expanded', 'false')
  await expect(legend).toBeHidden()
})

test('one panel can have the page to itself', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.getByTestId('focus-2').click()
  await expect(page.getByTestId('panel-2')).toBeVisible()
  for (const gone of ['panel-1', 'map-menu', 'tool-wall', 'column'])
    await expect(page.getByTestId(gone)).toBeHidden()
  expect(await mapShare(race)).toBeGreaterThan(60)
  await page.getByTestId('play').click()
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('panel-1')).toBeVisible()
  await page.keyboard.press('f')
  await expect(page.getByTestId('panel-2')).toBeHidden()
  await page.keyboard.press('f')
  await expect(page.getByTestId('panel-2')).toBeVisible()
  await expect(page.getByTestId('map-menu')).toBeVisible()
})

for (const [width, height] of [
  [390, 844],
  [1280, 720],
] as const)
  test(`in focus, and with several goals, controls stay in sight at ${width} × ${height}`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height })
    const race = new RacePage(page)
    await race.openAtRest()
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    await page.getByTestId('focus-1').click()
    await nothingCutOff(page)
    await page.getByTestId('leave-focus').click()
    await race.menu('map-menu', 'gallery-paper-fire')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await page.getByTestId('play').click()
    await expect.poll(async () => (await race.result(1)).summary?.metrics ?? null).not.toBeNull()
    await nothingCutOff(page)
  })

test('the wheel scrolls over a whole map, and zooms with Ctrl or over a magnified one', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 })
  const race = new RacePage(page)
  await race.openAtRest()
  await raceWith(race, 4)
  const grid = page.locator('.panel-grid')
  const scrolled = () => grid.evaluate((element) => element.scrollTop)
  const box = await race.stage(1).boundingBox()
  if (!box) throw new Error('there is no stage')
  await page.mouse.move(box.x + 50, box.y + 50)
  await page.mouse.wheel(0, 60)
  await expect.poll(scrolled).toBeGreaterThan(40)
  // Taking a picture brings the map whole into sight.
  await race.shot(1)
  const before = await scrolled()
  await page.keyboard.down('Control')
  await race.seesMotion(1, () => page.mouse.wheel(0, -200))
  await page.keyboard.up('Control')
  await race.seesMotion(1, () => page.mouse.wheel(0, -200))
  expect(await scrolled()).toBe(before)
})

async function raceWith(race: RacePage, count: number): Promise<void> {
  const { page } = race
  const panels = page.locator('.panel')
  const ids = ['ant-system', 'astar', ...PLANNERS]
  for (let now = await panels.count(); now < count; now++) {
    await page.getByTestId('add-panel').click()
    // Where the menu is scrolled, a press would take it out of sight.
    await page.getByTestId(`add-${ids[now]}`).evaluate((item: HTMLElement) => item.click())
  }
  await expect(panels).toHaveCount(count)
  await race.ready()
  await race.frame()
}

/** Percent of the window that shows maps: their cells, not the room around them. */
async function mapShare(race: RacePage): Promise<number> {
  const { page } = race
  await race.frame()
  const { spec } = (await race.session()).scenario
  const { stages, bounds, dpr } = await page.evaluate(() => {
    const boxOf = (element: Element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect()
      return { left, top, right, bottom }
    }
    const stages = [...document.querySelectorAll('.panel:not([hidden]) .stage')].map(boxOf)
    const grid = document.querySelector('.panel-grid')
    return { stages, bounds: grid && boxOf(grid), dpr: devicePixelRatio }
  })
  const { width, height } = page.viewportSize() ?? { width: 1, height: 1 }
  let seen = 0
  for (const { left, top, right, bottom } of stages) {
    const size = {
      width: Math.round((right - left) * dpr),
      height: Math.round((bottom - top) * dpr),
      dpr,
    }
    const { scale, originX, originY } = placement(WHOLE_MAP, size, spec)
    const [x, y] = [left + originX / dpr, top + originY / dpr]
    const within = (from: number, length: number, least: number, most: number) =>
      Math.max(0, Math.min(from + length, most) - Math.max(from, least))
    const wide = within(x, (spec.width * scale) / dpr, bounds?.left ?? 0, bounds?.right ?? width)
    const high = within(y, (spec.height * scale) / dpr, bounds?.top ?? 0, bounds?.bottom ?? height)
    seen += wide * high
  }
  return (100 * seen) / (width * height)
}

/** No sideways scroll; every control of bars and panel heads is whole, but for what a bar scrolls. */
async function nothingCutOff(page: Page): Promise<void> {
  const found = await page.evaluate(() => {
    const wide = document.documentElement.scrollWidth - innerWidth
    // The page itself is as tall as the window: only its parts scroll.
    const tall = document.documentElement.scrollHeight - innerHeight
    const controls = document.querySelectorAll(
      '.panel-head :is(button, select), .header button, .play-bar :is(button, input)',
    )
    const cut = [...controls].filter((control) => {
      const box = control.getBoundingClientRect()
      const outer = (control.closest('.panel') ?? document.documentElement).getBoundingClientRect()
      return box.width > 0 && (box.left < outer.left - 0.5 || box.right > outer.right + 0.5)
    })
    return {
      wide,
      tall,
      cut: cut.map(
        (control) => control.getAttribute('data-testid') ?? control.outerHTML.slice(0, 80),
      ),
    }
  })
  expect(found).toEqual({ wide: 0, tall: 0, cut: [] })
}
