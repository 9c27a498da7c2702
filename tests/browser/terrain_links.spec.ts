import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { expectClean } from './axe'
import { freshRace, RacePage } from './race_page'
import { ASC, KNOWN, OBLONG_ASC } from './rasters'
import {
  dialog,
  expectHeights,
  openAsc,
  openTerrain,
  scenarioOf,
  settledDown,
} from './terrain_page'

const DATA = process.env.FORMICARIUM_DATA

test.describe('terrains in links and files', () => {
  test('a link brings the heights back bit by bit, and the runs are verified', async ({
    page,
    browser,
  }) => {
    const race = await openAsc(page, OBLONG_ASC.replace('12 16 30', '12.25 16.0625 30.1'))
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    const link = await race.shareLink()
    const session = await race.session()
    const other = await freshRace(browser, link)
    const opened = await other.session()
    expect(opened.scenario).toEqual(session.scenario)
    await expectHeights(other, session.scenario.heights ?? [])
    for (const place of [1, 2])
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    await other.page.context().close()
  })

  test('a generated terrain is in a short link, with the walls drawn on it', async ({
    page,
    browser,
  }) => {
    test.slow()
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-fractal').click()
    await page.getByTestId('generate-roughness').fill('70')
    await page.getByTestId('generate-side-129').click()
    await page.getByTestId('generate').click()
    await expect(page.getByTestId('generate-dialog')).toBeHidden()
    await settledDown(race)
    const { spec, origin } = await scenarioOf(race)
    expect([spec.width, spec.height, spec.resolution]).toEqual([129, 129, 30])
    expect(origin).toMatchObject({ generator: 'fractal', density: 0.7 })
    await race.drag([
      [60, 60],
      [70, 60],
    ])
    expect(await race.walls()).toBe(11)
    const link = await race.shareLink()
    console.log(`link to a generated 129 × 129 terrain: ${link.length} characters`)
    expect(link.length).toBeLessThan(2000)
    const session = await race.session()
    const other = await freshRace(browser, link)
    expect((await other.session()).scenario).toEqual(session.scenario)
    await other.page.context().close()
  })

  test('a session file brings heights and rules back', async ({ page }) => {
    const race = await openAsc(page)
    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('model-slices').click()
    await race.applyRules()
    const before = await scenarioOf(race)
    const { bytes } = await race.exported('experiment')
    const document = JSON.parse(bytes.toString('utf8'))
    expect(document.heights[3]).toEqual([null, 15, 28, 33, 31, 27])
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.importByButton('again.json', bytes)
    await expect.poll(async () => (await scenarioOf(race)).heights?.length).toBe(30)
    expect(await scenarioOf(race)).toEqual(before)
    for (const [spoil, word] of [
      [{ ...document, heights: document.heights.slice(1) }, /heights has 4 rows/i],
      [{ ...document, heights: undefined }, /heights are missing/i],
      [
        { ...document, scenario: { ...document.scenario, terrain: undefined } },
        /terrain is missing/i,
      ],
    ] as const) {
      await race.paste(JSON.stringify(spoil))
      await expect(page.getByTestId('toast-error').last()).toContainText(word)
    }
    expect(await scenarioOf(race)).toEqual(before)
  })

  test('a reload keeps the terrain', async ({ page }) => {
    const race = await openAsc(page)
    await page.waitForFunction(() => sessionStorage.getItem('formicarium.session') !== null)
    await page.reload()
    await race.ready()
    await expectHeights(race, KNOWN)
  })

  test('every format that holds heights brings them back', async ({ page }) => {
    const race = await openAsc(page)
    const asc = await race.exported('esri-ascii')
    expect(asc.name).toMatch(/\.asc$/)
    const csv = await race.exported('height-table')
    expect(csv.bytes.toString('utf8').split(/\r?\n/)[1]).toBe('11,14,18,24,26,28')
    const tif = await race.exported('geotiff')
    expect(tif.bytes.subarray(0, 2).toString('latin1')).toMatch(/II|MM/)
    const json = await race.exported('scenario')
    for (const { name, bytes } of [asc, tif, json]) {
      await race.menu('map-menu', 'gallery-open-field')
      await expect.poll(async () => (await scenarioOf(race)).heights).toBeNull()
      await race.importByButton(name, bytes)
      if (name.endsWith('json'))
        await expect.poll(async () => (await scenarioOf(race)).heights?.length).toBe(30)
      else {
        await page.getByTestId('terrain-open').click()
        await expect(dialog(page)).toBeHidden()
      }
      await expectHeights(race, KNOWN)
      expect((await scenarioOf(race)).spec.resolution).toBe(10)
    }
  })

  test('formats without heights say that they lose them', async ({ page }) => {
    const race = await openAsc(page)
    await race.menu('map-menu', 'open-export')
    await expect(page.getByTestId('export-flattens')).toBeHidden()
    await page.getByTestId('export-movingai-map').click()
    await expect(page.getByTestId('export-flattens')).toBeVisible()
    await expect(page.getByTestId('export-preview')).toHaveValue(/@@\.\.\.\.\s*$/)
  })
})

test.describe('terrains made here', () => {
  test('hills: three planners with 16 moves, one of them proven', async ({ page }) => {
    test.slow()
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-terrain-hills')
    await expect
      .poll(async () => (await race.session()).panels.map((panel) => panel.planner))
      .toEqual(['terrain-epf', 'terrain-aco', 'astar'])
    await race.ready()
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /\d/)
    const optimum = Number(await page.getByTestId('optimum').getAttribute('data-value'))
    expect(optimum).toBeGreaterThan(60)
    for (const { summary } of await race.results())
      if (summary?.value != null) expect(summary.value).toBeGreaterThanOrEqual(optimum - 1e-9)
  })

  test('slices: the textbook’s race, compared by cost', async ({ page }) => {
    test.slow()
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-terrain-slices')
    await expect.poll(async () => (await race.session()).panels.length).toBe(4)
    await race.ready()
    await page.evaluate(() => window.formicarium.run())
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-objective', 'slice-cost')
    await expect(page.getByTestId('optimum')).toContainText(/cost by slices/i)
    await expect(page.getByTestId('gap-4')).toHaveAttribute('data-gap', '0')
    await expect(page.getByTestId('metric-levelCost-4')).toBeVisible()
    await expect(page.getByTestId('readout-value-4')).toBeVisible()
    await page.locator('body').press('r')
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('measure-length').click()
    await race.applyRules()
    await expect(page.getByTestId('optimum')).toContainText(/path by slices/i)
  })

  test('the level of an end is changed by keys', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-slices')
    const level = async () => (await scenarioOf(race)).spec.terrain?.slices?.start_level ?? 0
    const before = await level()
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('PageUp')
    await page.keyboard.press('PageUp')
    await expect.poll(level).toBe(before + 2)
    await page.keyboard.press('PageDown')
    await expect.poll(level).toBe(before + 1)
    await page.keyboard.press('Control+z')
    await expect.poll(level).toBe(before)
  })
})

test('the same in Chinese, without a word of English', async ({ page }) => {
  const race = await openAsc(page)
  await race.menu('language', 'language-zh-CN')
  await expect(page.getByTestId('share')).toHaveText('分享')
  await race.paste(OBLONG_ASC)
  await expect(page.getByTestId('terrain-open')).toContainText('打开 3 × 5 格')
  await page.getByTestId('crop-x').fill('9')
  await page.getByTestId('crop-x').press('Tab')
  await expect(dialog(page).getByRole('alert')).toBeVisible()
  const words = async () =>
    (await page.locator('dialog').innerText())
      .replace(/ESRI ASCII|GeoTIFF|SRTM|CSV|MovingAI|MATLAB|NumPy|Formicarium|JSON|CSV/g, '')
      .replace(/\.(asc|tif|hgt|csv|map|scen|json)\b/g, '')
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
  await page.keyboard.press('Escape')
  await race.menu('map-menu', 'open-resize')
  await page.getByTestId('model-slices').click()
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
  await race.applyRules()
  await expect(page.getByTestId('panel-1').getByRole('alert')).toContainText(
    '该规划器不能按切片规划',
  )
  await race.menu('map-menu', 'open-generate')
  await page.getByTestId('generate-hills').click()
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
})

test('the five surveys open, whole and shrunk', async ({ page }) => {
  test.skip(!DATA, 'FORMICARIUM_DATA is not set')
  test.slow()
  const race = new RacePage(page)
  await race.openAtRest()
  // In degrees cells are longer than wide: in square ones there are fewer columns.
  for (const [name, size, opened] of [
    ['dem/DEM_10m.asc', [67, 53], [67, 53]],
    ['dem/hugo_site.asc', [76, 55], [76, 55]],
    ['dem/srtmgl3_144x144.asc', [144, 144], [110, 144]],
    ['dem/west_bijou_gully.asc', [43, 89], [43, 89]],
    ['dem/pysheds_dem.tif', [367, 359], [309, 359]],
    ['papers/HeightData_21x21.csv', [21, 21], [21, 21]],
  ] as const) {
    await race.importByButton(name.replace(/.*\//, ''), readFileSync(join(DATA ?? '', name)))
    await expect(page.getByTestId('raster-size'), name).toHaveText(`${size[0]} × ${size[1]}`)
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    const { spec, heights } = await scenarioOf(race)
    const cells = opened[0] * opened[1]
    expect([spec.width, spec.height, heights?.length], name).toEqual([...opened, cells])
    await race.ready()
  }
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious in the dialogs of terrains (${scheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme })
    const race = new RacePage(page)
    await race.openAtRest()
    await race.paste(OBLONG_ASC)
    await page.getByTestId('crop-x').fill('9')
    await page.getByTestId('crop-x').press('Tab')
    await expectClean(page, 'import')
    await page.getByTestId('crop-whole').click()
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    await race.menu('map-menu', 'open-resize')
    await expect(page.getByTestId('resize-dialog')).toBeVisible()
    await expectClean(page, 'surface')
    await page.getByTestId('model-slices').click()
    await expectClean(page, 'slices')
    await race.applyRules()
    await expect(page.getByTestId('panel-1').getByRole('alert')).toBeVisible()
    await expectClean(page, 'refused')
    await race.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-hills').click()
    await expectClean(page, 'generate')
  })
}

test('on a phone the dialog of a raster fits and can be used by touch @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.paste(ASC)
  await expect(dialog(page)).toBeVisible()
  const box = await dialog(page).boundingBox()
  expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= 390).toBe(true)
  const wide = await dialog(page).evaluate((element) => element.scrollWidth - element.clientWidth)
  expect(wide).toBe(0)
  await page.getByTestId('crop-height').fill('3')
  await page.getByTestId('crop-height').blur()
  await page.getByTestId('terrain-open').tap()
  await expect(dialog(page)).toBeHidden()
  expect((await scenarioOf(race)).heights?.length).toBe(18)
})
