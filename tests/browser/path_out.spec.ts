/** Paths saved for other programs: what the menu offers, what comes down, and that it is the command line's. */
import { readFileSync } from 'node:fs'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

/** Three columns and two rows of 2 m with a wall between the ends, its lower left corner at (10, 20). */
const scenario = (frame: string | null) =>
  JSON.stringify({
    format: 'formicarium/scenario@1',
    name: 'yard',
    width: 3,
    height: 2,
    resolution: 2,
    start: [0, 0],
    goals: [{ at: [2, 0] }],
    map: { rows: ['.@.', '...'] },
    ...(frame === null ? {} : { world: { x: 10, y: 20, yaw: 0, frame } }),
  })

/** Opens the map and lets the first panel's search end. */
async function solved(page: Page, text: string): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.evaluate((map) => window.formicarium.load(map), text)
  await page.getByTestId('planner-1').selectOption('astar')
  await page.getByTestId('remove-2').click()
  await page.getByTestId('play').click()
  await expect(page.getByTestId('status-1')).toHaveAttribute('data-status', 'optimal')
  return race
}

async function saved(page: Page, format: string): Promise<{ name: string; text: string }> {
  await page.getByTestId('save-path-1').click()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(`path-${format}`).click(),
  ])
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') }
}

test('a path is saved in every format that its map can give', async ({ page }) => {
  await solved(page, scenario('EPSG:25832'))
  const csv = await saved(page, 'path-csv')
  expect(csv).toEqual({
    name: 'yard.astar.path.csv',
    text: 'x,y,x_m,y_m\n0,0,11,23\n0,1,11,21\n1,1,13,21\n2,1,15,21\n2,0,15,23\n',
  })
  const cells = [
    [0, 0],
    [0, 1],
    [1, 1],
    [2, 1],
    [2, 0],
  ]
  const json = await saved(page, 'path-json')
  expect(json.name).toBe('yard.astar.path.json')
  expect(JSON.parse(json.text)).toMatchObject({
    format: 'formicarium/path@1',
    kind: 'steps',
    frame: 'EPSG:25832',
    cells,
    length: 4,
    length_metres: 8,
  })
  const yaml = await saved(page, 'nav-msgs')
  expect(yaml.text.match(/^- header:/gm)).toHaveLength(5)
  expect(yaml.text).toContain('frame_id: "EPSG:25832"')
  const geojson = await saved(page, 'geojson')
  expect(geojson.name).toBe('yard.astar.geojson')
  expect(JSON.parse(geojson.text).geometry.coordinates[4]).toEqual([15, 23])
  await expect(page.getByText('EPSG:25832, named by the member')).toBeVisible()
  const svg = await saved(page, 'svg')
  expect(svg.text).toContain('points="0,0 0,1 1,1 2,1 2,0"')
  // A drawing that a browser shows.
  const drawn = await page.evaluate(
    (text) => new DOMParser().parseFromString(text, 'image/svg+xml').documentElement.nodeName,
    svg.text,
  )
  expect(drawn).toBe('svg')
})

test('what cannot be saved says why, and saves nothing', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.evaluate((map) => window.formicarium.load(map), scenario('map'))
  await page.getByTestId('save-path-1').click()
  const geojson = page.getByTestId('path-geojson')
  await expect(page.getByTestId('path-path-csv')).toHaveAttribute('aria-disabled', 'true')
  await expect(geojson).toContainText('There is no path yet.')
  await page.keyboard.press('Escape')
  await page.getByTestId('play').click()
  await expect(page.getByTestId('gap-1')).not.toHaveAttribute('data-gap', '')
  await page.getByTestId('save-path-1').click()
  await expect(geojson).toHaveAttribute('aria-disabled', 'true')
  await expect(geojson).toContainText('`map` is no coordinate system')
  await expect(page.getByTestId('path-svg')).toHaveAttribute('aria-disabled', 'false')
  await geojson.click({ force: true })
  // Nothing was chosen: the menu is still open.
  await expect(geojson).toBeVisible()
})

test('a map without a place lies at zero in a ROS path, which is said', async ({ page }) => {
  await solved(page, scenario(null))
  const { text } = await saved(page, 'nav-msgs')
  expect(text).toContain('frame_id: "map"')
  await expect(page.getByText('lower left corner is (0, 0)')).toBeVisible()
})

test('the menu goes by keys', async ({ page }) => {
  await solved(page, scenario('EPSG:25832'))
  await page.getByTestId('save-path-1').focus()
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('path-path-csv')).toBeFocused()
  await page.keyboard.press('End')
  await expect(page.getByTestId('path-svg')).toBeFocused()
})

test('where heads are narrow, paths are saved in “Export” @phone', async ({ page }) => {
  const race = await solved(page, scenario('map'))
  await race.menu('map-menu', 'open-export')
  const offer = page.getByTestId('path-offer')
  await offer.getByTestId('path-as').selectOption('geojson')
  await expect(offer).toContainText('`map` is no coordinate system')
  await expect(offer.getByTestId('path-save')).toBeDisabled()
  await offer.getByTestId('path-as').selectOption('path-csv')
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    offer.getByTestId('path-save').click(),
  ])
  expect(download.suggestedFilename()).toBe('yard.astar.path.csv')
  const box = await offer.getByTestId('path-save').boundingBox()
  expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= 390).toBe(true)
  await expectClean(page, 'a path in Export')
})

test('Export offers no path before there is one', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'open-export')
  await expect(page.getByTestId('path-offer')).toContainText('There is no path yet.')
})

test('a narrow head leaves its room to the rest; sideways there is enough @phone', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await expect(page.getByTestId('save-path-1')).toBeHidden()
  await page.getByTestId('focus-1').click()
  await expect(page.getByTestId('save-path-1')).toBeHidden()
  await page.setViewportSize({ width: 844, height: 390 })
  await expect(page.getByTestId('save-path-1')).toBeVisible()
})
