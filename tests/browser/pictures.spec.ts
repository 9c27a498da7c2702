/** Pictures to take away: real vectors, the numbers of the run, the same bytes for the same state. */
import { readFile } from 'node:fs/promises'
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { openTerrain } from './terrain_page'
import { sessionOf } from './units/sessions'

async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  await expect(page.getByTestId(button)).toBeEnabled()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(button).click(),
  ])
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) }
}

/** The dialog with a picture, by way of the export dialog. */
async function openPictures(race: RacePage): Promise<void> {
  await race.menu('map-menu', 'open-export')
  await race.page.getByTestId('export-picture').click()
  await expect(race.page.getByTestId('picture-preview')).toHaveAttribute('data-ready', 'true')
}

/** What a parser of XML finds. */
function parsed(page: Page, text: string) {
  return page.evaluate((source) => {
    const svg = new DOMParser().parseFromString(source, 'image/svg+xml')
    const all = (selector: string) => [...svg.querySelectorAll(selector)]
    return {
      fault: svg.querySelector('parsererror')?.textContent ?? null,
      scripts: svg.querySelectorAll('script, foreignObject, [onload], [onerror]').length,
      images: svg.querySelectorAll('image').length,
      lines: all('polyline.path').map((line) =>
        (line.getAttribute('points') ?? '')
          .split(' ')
          .map((point) => point.split(',').map((part) => Number(part) - 0.5)),
      ),
      texts: all('text').map((node) => node.textContent ?? ''),
      colours: all('.cells path, .cells rect').map((node) => node.getAttribute('fill')),
      styles: svg.querySelectorAll('style').length,
    }
  }, text)
}

async function openRun(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 30 }))
  return race
}

test('the map is vectors: the paths of the run, its labels, its layer', async ({ page }) => {
  const race = await openRun(page)
  const results = await race.results()
  await openPictures(race)
  const { name, bytes } = await saved(page, 'picture-svg')
  expect(name).toMatch(/-map\.svg$/)
  const one = await parsed(page, bytes.toString())
  expect(one.fault).toBeNull()
  expect([one.images, one.styles]).toEqual([0, 0])
  expect(one.lines).toEqual([results[0]?.path])
  const length = results[0]?.summary?.metrics?.length.toFixed(2) ?? '?'
  expect(one.texts.some((text) => text.includes(length) && text.includes('%'))).toBe(true)
  expect(one.texts).toContain('Pheromone (τ)')
  expect(one.texts.some((text) => text.includes('Seed 1 · Iteration 30'))).toBe(true)
  expect(one.colours.length).toBeGreaterThan(3)
  expect((await saved(page, 'picture-svg')).bytes.equals(bytes)).toBe(true)

  await page.getByTestId('picture-whose').selectOption('all')
  await expect(page.getByTestId('picture-preview')).toHaveAttribute('data-ready', 'true')
  const all = await parsed(page, (await saved(page, 'picture-svg')).bytes.toString())
  expect(all.lines).toEqual(results.map(({ path }) => path))
  // Free cells, and walls.
  expect(all.colours).toHaveLength(2)
  await page.getByTestId('picture-print').click()
  await expect(page.getByTestId('picture-preview')).toHaveAttribute('data-ready', 'true')
  const print = await parsed(page, (await saved(page, 'picture-svg')).bytes.toString())
  expect(print.colours).toContain('#ffffff')
})

test('the chart is taken away from its card, also as pixels', async ({ page }) => {
  const race = await openRun(page)
  await page.getByTestId('chart-picture').click()
  await expect(page.getByTestId('picture-preview')).toHaveAttribute('data-ready', 'true')
  const { bytes } = await saved(page, 'picture-svg')
  const found = await parsed(page, bytes.toString())
  expect(found.fault).toBeNull()
  for (const { summary } of await race.results())
    expect(found.texts.join()).toContain(summary?.metrics?.length.toFixed(2))
  const widths = []
  for (const scale of [2, 3]) {
    const png = await saved(page, `picture-png-${scale}`)
    expect(png.bytes.subarray(1, 4).toString()).toBe('PNG')
    widths.push(png.bytes.readUInt32BE(16))
  }
  expect(widths[0]).toBeGreaterThan(1400)
  expect(2 * (widths[1] ?? 0)).toBe(3 * (widths[0] ?? 0))
})

test('names stay text', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const evil = '<script>alert(1)</script>"><image href=x onerror=alert(1)> & \u0001'
  await page.evaluate((name) => {
    const session = window.formicarium.session()
    if (!session) return
    session.scenario.spec.name = name
    return window.formicarium.load(session)
  }, evil)
  await race.ready()
  await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
  await openPictures(race)
  const { bytes } = await saved(page, 'picture-svg')
  const found = await parsed(page, bytes.toString())
  expect(found.fault).toBeNull()
  expect([found.scripts, found.images]).toEqual([0, 0])
  expect(found.texts.join('')).toContain('<script>alert(1)</script>')
})

test('a terrain has its contour lines while the page shows them, and hatching where there is no data', async ({
  page,
}) => {
  const race = await openTerrain(page, 'terrain-hills')
  const found = async () => {
    await openPictures(race)
    const text = (await saved(page, 'picture-svg')).bytes.toString()
    await race.leaveDialog()
    return page.evaluate((source) => {
      const svg = new DOMParser().parseFromString(source, 'image/svg+xml')
      const strengths = [...svg.querySelectorAll('.contours path')]
      return {
        fault: svg.querySelector('parsererror')?.textContent ?? null,
        lines: strengths.map((path) => (path.getAttribute('d') ?? '').split('M').length - 1),
        hatched: svg.querySelectorAll('.no-data pattern').length,
        said: svg.documentElement.textContent?.includes('Contour lines every') ?? false,
      }
    }, text)
  }
  const shown = await found()
  expect(shown).toMatchObject({ fault: null, hatched: 0, said: true })
  expect(shown.lines).toHaveLength(2)
  expect(Math.min(...shown.lines)).toBeGreaterThan(0)
  await page.getByTestId('show-contours').click()
  expect(await found()).toEqual({ fault: null, lines: [], hatched: 0, said: false })
  await page.evaluate(async () => {
    const session = window.formicarium.session()
    if (!session?.scenario.heights) return
    const { spec, heights } = session.scenario
    for (const cell of [5, 6, 7]) heights[spec.width * 3 + cell] = Number.NaN
    for (const cell of [5, 6, 7]) session.scenario.cells[spec.width * 3 + cell] = 1
    await window.formicarium.load(session)
  })
  await race.ready()
  expect((await found()).hatched).toBe(1)
})

test('the cells of a large map are a picture inside the picture, which says so', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const { cells } = sessionOf(1000, 1000).scenario
  await page.evaluate(
    (blocked) => {
      const session = window.formicarium.session()
      if (!session) return
      const { scenario } = session
      scenario.spec = { ...scenario.spec, width: 1000, height: 1000, start: [0, 0] }
      scenario.spec.goals = scenario.spec.goals.map((goal) => ({ ...goal, at: [999, 999] }))
      scenario.cells = new Uint8Array(1_000_000)
      for (const cell of blocked) scenario.cells[cell] = 1
      session.panels = session.panels.slice(1)
      return window.formicarium.load(session)
    },
    [...cells.keys()].filter((cell) => cells[cell] === 1 && cell > 0 && cell < 999_999),
  )
  await race.ready()
  await openPictures(race)
  const { bytes } = await saved(page, 'picture-svg')
  const found = await parsed(page, bytes.toString())
  expect([found.fault, found.images]).toEqual([null, 1])
  expect(found.texts.join()).toContain('PNG')
  console.log(`1000 × 1000 cells: ${Math.round(bytes.length / 1024)} KB`)
  expect(bytes.length).toBeLessThan(3 * 1024 * 1024)
})
