import { expect, test } from '@playwright/test'
import { freshRace, RacePage } from './race_page'
import { randomCells } from './units/sessions'
import { drawn } from './workers'

const SIDE = 512

/** 30 % walls, in a frame of free cells so that start and goal are connected. */
function largeMap(): string {
  const cells = randomCells(SIDE, SIDE, 0.3)
  const edge = (at: number) => at === 0 || at === SIDE - 1
  const rows = Array.from({ length: SIDE }, (_, y) =>
    Array.from({ length: SIDE }, (_, x) =>
      edge(x) || edge(y) || cells[y * SIDE + x] === 0 ? '.' : '@',
    ).join(''),
  )
  return `type octile\nheight ${SIDE}\nwidth ${SIDE}\nmap\n${rows.join('\n')}\n`
}

test('a 512 × 512 map with 30 % walls imports, runs, and offers a file where a link would be too long', async ({
  page,
  browser,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.importByButton('large.map', largeMap())
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(SIDE)
  await race.ready()
  await page.getByTestId('play').click()
  await race.seesMotion()
  await page.locator('body').press('Space')
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'paused')
  await race.setSpeed(8)
  await page.locator('body').press('Space')
  await expect.poll(() => race.antMoves(), { timeout: 30_000 }).toBeGreaterThan(0)
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal', {
    timeout: 20_000,
  })
  // Not by a key: it would begin anew where the ants have ended as well.
  await page.evaluate(() => window.formicarium.pause())

  await page.getByTestId('share').click()
  await expect(page.getByTestId('share-too-long')).toContainText(/8,?000/)
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId('share-file').click(),
  ])
  const path = await download.path()
  await page.keyboard.press('Escape')

  const other = await freshRace(browser, page.url())
  await other.menu('map-menu', 'open-import')
  await other.page.getByTestId('import-file').setInputFiles({
    name: 'large.experiment.json',
    mimeType: 'application/json',
    buffer: await import('node:fs').then(({ readFileSync }) => readFileSync(path)),
  })
  await expect.poll(async () => (await other.session()).scenario.spec.width).toBe(SIDE)
  expect((await other.session()).scenario.cells).toEqual((await race.session()).scenario.cells)
  await expect(other.page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified', {
    timeout: 30_000,
  })
  await other.page.context().close()
})

test('an edit on a 512 × 512 map is shown within a frame or two', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.paste(largeMap())
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(SIDE)
  await race.drag([
    [100, 100],
    [400, 300],
  ])
  await page.locator('body').press('Control+z')
  await race.ready()
  await drawn(page)
  await page.getByTestId('play').click()
  await race.seesMotion()
})

test('two panels playing on 256 × 256 leave the page its frames', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.pause())
  await race.menu('map-menu', 'open-generate')
  await page.getByTestId('generate-random').click()
  await page.getByTestId('generate-width').fill('256')
  await page.getByTestId('generate-height').fill('256')
  await page.getByTestId('generate').click()
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(256)
  await race.ready()
  await page.getByTestId('play').click()
  await race.reportPageThread('two panels on a random 256 × 256 map')
})
