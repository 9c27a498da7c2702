import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test } from '@playwright/test'
import { freshLab, Lab } from './lab'
import { ASC, CSV, geotiff, HEIGHTS, hgt, KNOWN, OBLONG_ASC } from './rasters'

const DATA = process.env.FORMICARIUM_DATA

const dialog = (page: Page) => page.getByTestId('terrain-dialog')

const scenarioOf = async (lab: Lab) => (await lab.session()).scenario

/** Heights bit by bit, no data included. */
async function expectHeights(lab: Lab, expected: ArrayLike<number>): Promise<void> {
  const { heights } = await scenarioOf(lab)
  const same =
    heights?.length === expected.length && heights.every((h, i) => Object.is(h, expected[i]))
  expect(same, `${heights?.slice(0, 40)}`).toBe(true)
}

/** Opens the small grid by its defaults. */
async function openAsc(page: Page, text = ASC): Promise<Lab> {
  const lab = new Lab(page)
  await lab.openAtRest()
  await lab.paste(text)
  await page.getByTestId('terrain-open').click()
  await expect(dialog(page)).toBeHidden()
  await lab.ready()
  return lab
}

test.describe('rasters of heights', () => {
  test.beforeEach(async ({ page }) => new Lab(page).openAtRest())

  const files: [name: string, content: string | Buffer, kind: RegExp, heights: number[]][] = [
    ['small.asc', ASC, /ESRI/, KNOWN],
    ['dos.asc', ASC.replaceAll('\n', '\r\n'), /ESRI/, KNOWN],
    ['small.tif', geotiff(), /GeoTIFF/, KNOWN],
    ['small.csv', CSV, /Table/, HEIGHTS.flat().map((height) => Math.max(0, height))],
  ]
  for (const [name, content, kind, heights] of files) {
    test(`${name} is surveyed, then opened by Enter`, async ({ page }) => {
      const lab = new Lab(page)
      const walls = await lab.walls()
      await lab.importByButton(name, content)
      await expect(dialog(page)).toBeVisible()
      await expect(page.getByTestId('raster-kind')).toHaveText(kind)
      await expect(page.getByTestId('raster-size')).toHaveText('6 × 5')
      await expect(page.getByTestId('raster-heights')).toHaveText(/to 35/)
      expect(await lab.walls()).toBe(walls)
      await page.keyboard.press('Enter')
      await expect(dialog(page)).toBeHidden()
      await expectHeights(lab, heights)
      const { spec, cells } = await scenarioOf(lab)
      expect([...cells]).toEqual(heights.map((height) => (Number.isNaN(height) ? 1 : 0)))
      expect(spec.terrain).toEqual({ vertical_unit: 1, max_slope: 90 })
      expect(spec.resolution).toBe(name === 'small.csv' ? 1 : 10)
      await lab.ready()
      await page.locator('body').press('End')
      await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    })
  }

  test('dropped and pasted as well, and left with Escape', async ({ page }) => {
    const lab = new Lab(page)
    const before = await scenarioOf(lab)
    for (const bring of [
      () => lab.drop('small.asc', ASC),
      () => lab.paste(ASC),
      () => lab.paste(CSV),
    ]) {
      await bring()
      await expect(dialog(page)).toBeVisible()
      await page.keyboard.press('Escape')
      await expect(dialog(page)).toBeHidden()
    }
    expect(await scenarioOf(lab)).toEqual(before)
  })

  test('a part can be marked by numbers, and comes exactly as it is', async ({ page }) => {
    const lab = new Lab(page)
    await lab.paste(ASC)
    for (const [field, value] of [
      ['crop-x', 2],
      ['crop-width', 3],
      ['crop-y', 1],
      ['crop-height', 4],
    ] as const) {
      await page.getByTestId(field).fill(String(value))
      await page.getByTestId(field).press('Tab')
    }
    await expect(page.getByTestId('raster-crop')).toBeVisible()
    await page.getByTestId('crop-x').fill('4')
    await page.getByTestId('crop-x').press('Tab')
    await expect(dialog(page).getByRole('alert')).toContainText('6 × 5')
    await expect(page.getByTestId('terrain-open')).toBeDisabled()
    await page.getByTestId('crop-x').fill('2')
    await page.getByTestId('crop-x').press('Tab')
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    await expectHeights(
      lab,
      HEIGHTS.slice(1).flatMap((row) => row.slice(2, 5)),
    )
  })

  test('a part can be marked by dragging', async ({ page }) => {
    await new Lab(page).paste(ASC)
    const box = await page.getByTestId('raster-preview').boundingBox()
    if (!box) throw new Error('there is no picture')
    const at = (x: number, y: number) =>
      [box.x + (box.width * x) / 6, box.y + (box.height * y) / 5] as const
    await page.mouse.move(...at(4.5, 3.5))
    await page.mouse.down()
    await page.mouse.move(...at(2.5, 2))
    await page.mouse.move(...at(1.5, 0.5))
    await page.mouse.up()
    const value = (field: string) => page.getByTestId(field).inputValue()
    expect(await Promise.all(['crop-x', 'crop-y', 'crop-width', 'crop-height'].map(value))).toEqual(
      ['1', '0', '4', '4'],
    )
    await page.getByTestId('crop-whole').click()
    await expect(page.getByTestId('raster-crop')).toBeHidden()
    expect(await value('crop-width')).toBe('6')
  })

  test('cells that are not square can be made so, and the extent stays', async ({ page }) => {
    const lab = new Lab(page)
    await lab.paste(OBLONG_ASC)
    await expect(page.getByTestId('raster-cell')).toHaveText('15 × 30 m')
    await expect(page.getByTestId('raster-result')).toContainText('15 × 30 m')
    await page.getByTestId('size-square').click()
    await expect(page.getByTestId('size-width')).toHaveValue('3')
    await expect(page.getByTestId('size-height')).toHaveValue('5')
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    const { spec } = await scenarioOf(lab)
    expect([spec.width, spec.height, spec.resolution]).toEqual([3, 5, 30])
  })

  test('a large survey is offered in as many cells as can be watched', async ({ page }) => {
    test.slow()
    const lab = new Lab(page)
    await lab.importByButton('N40W106.hgt', hgt())
    await expect(page.getByTestId('raster-size')).toHaveText('1,201 × 1,201')
    await expect(page.getByTestId('size-width')).toHaveValue('513')
    await page.getByTestId('size-256').click()
    await page.getByTestId('size-square').click()
    await expect(page.getByTestId('size-height')).toHaveValue('256')
    const width = Number(await page.getByTestId('size-width').inputValue())
    // At 40° north a second of arc is shorter from west to east.
    expect(width / 256).toBeCloseTo(Math.cos((40.5 * Math.PI) / 180), 1)
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden({ timeout: 30_000 })
    const { spec, heights } = await scenarioOf(lab)
    expect([spec.width, spec.height]).toEqual([width, 256])
    expect(heights?.at(-1) ?? 0).toBeGreaterThan(2300)
  })

  test('what cannot be read is refused where the reader looks, and nothing on screen is lost', async ({
    page,
  }) => {
    const lab = new Lab(page)
    const before = await scenarioOf(lab)
    const spoilt: [string, string | Buffer][] = [
      ['short.asc', ASC.split('\n').slice(0, -3).join('\n')],
      ['letters.asc', ASC.replace('30 35 30', '30 x 30')],
      ['huge.asc', ASC.replace('ncols 6', 'ncols 60000').replace('nrows 5', 'nrows 60000')],
      ['cut.tif', geotiff().subarray(0, 190)],
      ['cut.hgt', hgt().subarray(0, 10_000)],
    ]
    for (const [name, content] of spoilt) {
      await lab.importByButton(name, content)
      const alert = page.getByTestId('import-dialog').getByRole('alert')
      await expect(alert, name).toBeVisible()
      expect((await alert.textContent())?.length, name).toBeGreaterThan(30)
      await page.keyboard.press('Escape')
    }
    await lab.paste(ASC.replace('30 35 30', '30 x 30'))
    await expect(page.getByTestId('toast-error')).toContainText('9')
    expect(await scenarioOf(lab)).toEqual(before)
  })

  test('scripts get the raster without being asked about it', async ({ page }) => {
    const lab = new Lab(page)
    expect(await page.evaluate((text) => window.formicarium.load(text), ASC)).toBe(true)
    await expectHeights(lab, KNOWN)
  })
})

test.describe('on a terrain', () => {
  test('nothing can be where there is no data, and that is said', async ({ page }) => {
    const lab = await openAsc(page)
    await lab.drag([[0, 4]])
    await expect(page.getByTestId('toast-warning')).toContainText('not known')
    expect(await lab.isWall([0, 4])).toBe(true)
    const { start } = (await scenarioOf(lab)).spec
    await page.getByTestId('tool-start').click()
    await lab.drag([[0, 3]])
    expect((await scenarioOf(lab)).spec.start).toEqual(start)
    await page.getByTestId('tool-wall').click()
    await lab.drag([
      [1, 2],
      [3, 2],
    ])
    expect(await lab.walls()).toBe(6)
    await lab.menu('map-menu', 'clear')
    expect(await lab.walls()).toBe(3)
    await page.getByTestId('map-menu').click()
    await expect(page.getByTestId('invert')).toHaveAttribute('aria-disabled', 'true')
  })

  test('undo and redo bring heights and rules back', async ({ page }) => {
    const lab = await openAsc(page)
    await lab.menu('map-menu', 'open-resize')
    await page.getByTestId('resize-width').fill('4')
    await page.getByTestId('model-slices').click()
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('resize-dialog')).toBeHidden()
    const cut = await scenarioOf(lab)
    expect([cut.spec.width, cut.heights?.length]).toEqual([4, 20])
    expect(cut.spec.terrain?.slices?.levels).toBe(20)
    await page.locator('body').press('Control+z')
    await expectHeights(lab, KNOWN)
    expect((await scenarioOf(lab)).spec.terrain).toEqual({ vertical_unit: 1, max_slope: 90 })
    await page.locator('body').press('Control+z')
    await expect.poll(async () => (await scenarioOf(lab)).heights).toBeNull()
    expect((await scenarioOf(lab)).spec.terrain).toBeUndefined()
    await page.locator('body').press('Control+Shift+z')
    await expectHeights(lab, KNOWN)
    await page.locator('body').press('Control+Shift+z')
    expect((await scenarioOf(lab)).spec.terrain?.slices).toEqual(cut.spec.terrain?.slices)
  })

  test('the rules of slices are set, checked and kept', async ({ page }) => {
    const lab = await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('model-slices').click()
    await page.getByTestId('slices-levels').fill('300')
    await page.getByTestId('slices-levels').press('Tab')
    await expect(page.getByTestId('slices-levels')).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByTestId('resize')).toBeDisabled()
    for (const [field, value] of [
      ['slices-levels', 9],
      ['slices-level', 5],
      ['slices-max_climb', 3],
      ['slices-max_aside', 1],
      ['slices-start_level', 8],
      ['slices-goal_level', 9],
    ] as const) {
      await page.getByTestId(field).fill(String(value))
      await page.getByTestId(field).press('Tab')
    }
    await page.getByTestId('measure-length').click()
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('terrain-model')).toContainText('9 levels of 5 m')
    const { spec } = await scenarioOf(lab)
    expect(spec.terrain).toEqual({
      vertical_unit: 1,
      slices: {
        level: 5,
        levels: 9,
        max_aside: 1,
        max_climb: 3,
        start_level: 8,
        goal_level: 9,
        measure: 'length',
      },
    })
    // 35 m of ground under levels up to 20 m: no place for an end there.
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('slices-level').fill('1')
    await page.getByTestId('slices-level').press('Tab')
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('no-place')).toBeVisible()
  })

  test('levels below the ground are lifted, and that is said', async ({ page }) => {
    const lab = await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('model-slices').click()
    for (const [field, value] of [
      ['slices-level', 5],
      ['slices-levels', 9],
      ['slices-start_level', 1],
      ['slices-goal_level', 9],
    ] as const) {
      await page.getByTestId(field).fill(String(value))
      await page.getByTestId(field).press('Tab')
    }
    await page.getByTestId('resize').click()
    // The start lies on 10 m: levels of 5 m begin at the second there.
    await expect(page.getByTestId('toast-warning')).toContainText(
      'start at level 2, goal at level 9',
    )
    await expect(page.getByTestId('terrain-model')).toHaveText('By slices, 9 levels of 5 m, 2 → 9')
    expect((await scenarioOf(lab)).spec.terrain?.slices?.start_level).toBe(2)
    await expect(page.getByTestId('panel-1').getByRole('alert')).toBeVisible()
    await expect(page.locator('.plot-hint')).toContainText('Cost by iteration')
  })

  test('a limit of slope is seen beside the moves', async ({ page }) => {
    await openAsc(page)
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('max-slope').fill('12.5')
    await page.getByTestId('max-slope').press('Tab')
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('terrain-model')).toHaveText(
      'On the surface, 8 moves, up to 12.5°',
    )
  })

  test('planners that do not know the ground are told apart, and a panel says what to do', async ({
    page,
  }) => {
    const lab = await openAsc(page)
    const option = (id: string) => page.getByTestId('planner-1').locator(`option[value="${id}"]`)
    await expect(option('theta-star')).toBeDisabled()
    await expect(option('ant-system')).toBeEnabled()
    await page.getByTestId('add-panel').click()
    await expect(page.getByTestId('add-theta-star')).toHaveAttribute('aria-disabled', 'true')
    await expect(page.getByTestId('add-theta-star')).toContainText('surface')
    await page.keyboard.press('Escape')
    await lab.menu('map-menu', 'open-resize')
    await page.getByTestId('model-slices').click()
    await page.getByTestId('resize').click()
    const trouble = page.getByTestId('panel-1').getByRole('alert')
    await expect(trouble).toContainText('does not plan by slices')
    await trouble.getByRole('button').click()
    await expect(trouble).toBeHidden()
    await lab.menu('map-menu', 'open-resize')
    await page.getByTestId('model-surface').click()
    await page.getByTestId('movement').selectOption('16-both-free')
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('terrain-model')).toContainText('16 moves')
    await expect(option('ant-system')).toBeDisabled()
    await expect(option('astar')).toBeEnabled()
  })

  test('16 moves go on a plane, too', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await page.getByTestId('planner-1').selectOption('astar')
    await lab.menu('map-menu', 'open-resize')
    await page.getByTestId('movement').selectOption('16-both-free')
    await page.getByTestId('resize').click()
    await lab.ready()
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    await expect(page.getByTestId('gap-2')).toHaveAttribute('data-gap', '0')
  })

  test('lengths are given in cells and metres, with climb, descent and slope', async ({ page }) => {
    await openAsc(page)
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    const value = async (id: string) =>
      Number(await page.getByTestId(`metric-${id}-2`).getAttribute('data-value'))
    await expect.poll(() => value('climb')).toBeGreaterThan(0)
    expect(await value('lengthMetres')).toBeCloseTo(10 * (await value('length')), 6)
    const { heights, spec } = await scenarioOf(new Lab(page))
    const at = ([x, y]: [number, number]) => heights?.[y * spec.width + x] ?? Number.NaN
    const rise = at(spec.goals[0]?.at ?? spec.start) - at(spec.start)
    expect((await value('climb')) - (await value('descent'))).toBeCloseTo(rise, 6)
    expect(await value('steepest')).toBeLessThan(90)
    await expect(page.getByTestId('metric-levelCost-2')).toBeHidden()
  })
})

test.describe('terrains in links and files', () => {
  test('a link brings the heights back bit by bit, and the runs are verified', async ({
    page,
    browser,
  }) => {
    const lab = await openAsc(page, OBLONG_ASC.replace('12 16 30', '12.25 16.0625 30.1'))
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    const link = await lab.shareLink()
    const session = await lab.session()
    const other = await freshLab(browser, link)
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
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-fractal').click()
    await page.getByTestId('generate-roughness').fill('70')
    await page.getByTestId('generate-side-129').click()
    await page.getByTestId('generate').click()
    await expect(page.getByTestId('generate-dialog')).toBeHidden()
    await lab.ready()
    const { spec, origin } = await scenarioOf(lab)
    expect([spec.width, spec.height, spec.resolution]).toEqual([129, 129, 30])
    expect(origin).toMatchObject({ generator: 'fractal', density: 0.7 })
    await lab.drag([
      [60, 60],
      [70, 60],
    ])
    expect(await lab.walls()).toBe(11)
    const link = await lab.shareLink()
    console.log(`link to a generated 129 × 129 terrain: ${link.length} characters`)
    expect(link.length).toBeLessThan(2000)
    const session = await lab.session()
    const other = await freshLab(browser, link)
    expect((await other.session()).scenario).toEqual(session.scenario)
    await other.page.context().close()
  })

  test('an experiment file brings heights and rules back', async ({ page }) => {
    const lab = await openAsc(page)
    await lab.menu('map-menu', 'open-resize')
    await page.getByTestId('model-slices').click()
    await page.getByTestId('resize').click()
    const before = await scenarioOf(lab)
    const { bytes } = await lab.exported('experiment')
    const document = JSON.parse(bytes.toString('utf8'))
    expect(document.heights[3]).toEqual([null, 15, 28, 33, 31, 27])
    await lab.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => lab.walls()).toBe(0)
    await lab.importByButton('again.json', bytes)
    await expect.poll(async () => (await scenarioOf(lab)).heights?.length).toBe(30)
    expect(await scenarioOf(lab)).toEqual(before)
    for (const [spoil, word] of [
      [{ ...document, heights: document.heights.slice(1) }, /heights has 4 rows/i],
      [{ ...document, heights: undefined }, /heights are missing/i],
      [
        { ...document, scenario: { ...document.scenario, terrain: undefined } },
        /terrain is missing/i,
      ],
    ] as const) {
      await lab.paste(JSON.stringify(spoil))
      await expect(page.getByTestId('toast-error').last()).toContainText(word)
    }
    expect(await scenarioOf(lab)).toEqual(before)
  })

  test('a reload keeps the terrain', async ({ page }) => {
    const lab = await openAsc(page)
    await page.waitForFunction(() => sessionStorage.getItem('formicarium.session') !== null)
    await page.reload()
    await lab.ready()
    await expectHeights(lab, KNOWN)
  })

  test('every format that holds heights brings them back', async ({ page }) => {
    const lab = await openAsc(page)
    const asc = await lab.exported('esri-ascii')
    expect(asc.name).toMatch(/\.asc$/)
    const csv = await lab.exported('height-table')
    expect(csv.bytes.toString('utf8').split(/\r?\n/)[1]).toBe('11,14,18,24,26,28')
    const tif = await lab.exported('geotiff')
    expect(tif.bytes.subarray(0, 2).toString('latin1')).toMatch(/II|MM/)
    const json = await lab.exported('scenario')
    for (const { name, bytes } of [asc, tif, json]) {
      await lab.menu('map-menu', 'gallery-open-field')
      await expect.poll(async () => (await scenarioOf(lab)).heights).toBeNull()
      await lab.importByButton(name, bytes)
      if (name.endsWith('json'))
        await expect.poll(async () => (await scenarioOf(lab)).heights?.length).toBe(30)
      else {
        await page.getByTestId('terrain-open').click()
        await expect(dialog(page)).toBeHidden()
      }
      await expectHeights(lab, KNOWN)
      expect((await scenarioOf(lab)).spec.resolution).toBe(10)
    }
  })

  test('formats without heights say that they lose them', async ({ page }) => {
    const lab = await openAsc(page)
    await lab.menu('map-menu', 'open-export')
    await expect(page.getByTestId('export-flattens')).toBeHidden()
    await page.getByTestId('export-movingai-map').click()
    await expect(page.getByTestId('export-flattens')).toBeVisible()
    await expect(page.getByTestId('export-preview')).toHaveValue(/@@\.\.\.\.\s*$/)
  })
})

test.describe('terrains made here', () => {
  test('hills: three planners with 16 moves, one of them proven', async ({ page }) => {
    test.slow()
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('map-menu', 'gallery-terrain-hills')
    await expect
      .poll(async () => (await lab.session()).panels.map((panel) => panel.planner))
      .toEqual(['terrain-epf', 'terrain-aco', 'astar'])
    await lab.ready()
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    const optimum = Number(await page.getByTestId('optimum').getAttribute('data-value'))
    expect(optimum).toBeGreaterThan(60)
    for (const { summary } of await lab.results())
      if (summary?.value != null) expect(summary.value).toBeGreaterThanOrEqual(optimum - 1e-9)
  })

  test('slices: the textbook’s race, compared by cost', async ({ page }) => {
    test.slow()
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('map-menu', 'gallery-terrain-slices')
    await expect.poll(async () => (await lab.session()).panels.length).toBe(4)
    await lab.ready()
    await page.evaluate(() => window.formicarium.run())
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-objective', 'slice-cost')
    await expect(page.getByTestId('optimum')).toContainText(/cost by slices/i)
    await expect(page.getByTestId('gap-4')).toHaveAttribute('data-gap', '0')
    await expect(page.getByTestId('metric-levelCost-4')).toBeVisible()
    await expect(page.getByTestId('readout-value-4')).toBeVisible()
    await page.locator('body').press('r')
    await page.getByTestId('terrain-model').click()
    await page.getByTestId('measure-length').click()
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('optimum')).toContainText(/path by slices/i)
  })

  test('the level of an end is changed by keys', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await lab.menu('map-menu', 'gallery-terrain-slices')
    await lab.ready()
    const level = async () => (await scenarioOf(lab)).spec.terrain?.slices?.start_level ?? 0
    const before = await level()
    await lab.stage().focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('PageUp')
    await page.keyboard.press('PageUp')
    expect(await level()).toBe(before + 2)
    await page.keyboard.press('PageDown')
    expect(await level()).toBe(before + 1)
    await page.keyboard.press('Control+z')
    expect(await level()).toBe(before)
  })
})

test('the same in Chinese, without a word of English', async ({ page }) => {
  const lab = await openAsc(page)
  await lab.menu('language', 'language-zh-CN')
  await expect(page.getByTestId('share')).toHaveText('分享')
  await lab.paste(OBLONG_ASC)
  await expect(page.getByTestId('terrain-open')).toContainText('打开 6 × 5 格')
  await page.getByTestId('crop-x').fill('9')
  await page.getByTestId('crop-x').press('Tab')
  const words = async () =>
    (await page.locator('dialog').innerText())
      .replace(/ESRI ASCII|GeoTIFF|SRTM|CSV|MovingAI|MATLAB|NumPy|Formicarium|JSON|CSV/g, '')
      .replace(/\.(asc|tif|hgt|csv|map|scen|json)\b/g, '')
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
  await page.keyboard.press('Escape')
  await lab.menu('map-menu', 'open-resize')
  await page.getByTestId('model-slices').click()
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
  await page.getByTestId('resize').click()
  await expect(page.getByTestId('panel-1').getByRole('alert')).toContainText(
    '该规划器不能按切片规划',
  )
  await lab.menu('map-menu', 'open-generate')
  await page.getByTestId('generate-hills').click()
  expect(await words()).not.toMatch(/[A-Za-z]{3,}/)
})

test('the five surveys open, whole and shrunk', async ({ page }) => {
  test.skip(!DATA, 'FORMICARIUM_DATA is not set')
  test.slow()
  const lab = new Lab(page)
  await lab.openAtRest()
  for (const [name, size] of [
    ['dem/DEM_10m.asc', [67, 53]],
    ['dem/hugo_site.asc', [76, 55]],
    ['dem/srtmgl3_144x144.asc', [144, 144]],
    ['dem/west_bijou_gully.asc', [43, 89]],
    ['dem/pysheds_dem.tif', [367, 359]],
    ['papers/HeightData_21x21.csv', [21, 21]],
  ] as const) {
    await lab.importByButton(name.replace(/.*\//, ''), readFileSync(join(DATA ?? '', name)))
    await expect(page.getByTestId('raster-size'), name).toHaveText(`${size[0]} × ${size[1]}`)
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    const { spec, heights } = await scenarioOf(lab)
    expect([spec.width, spec.height, heights?.length], name).toEqual([...size, size[0] * size[1]])
    await lab.ready()
  }
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious in the dialogs of terrains (${scheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme })
    const lab = new Lab(page)
    await lab.openAtRest()
    const expectClean = async (where: string) => {
      const { violations } = await new AxeBuilder({ page }).analyze()
      const serious = violations.filter(
        ({ impact }) => impact === 'serious' || impact === 'critical',
      )
      expect(
        serious.map(({ id, nodes }) => [id, nodes[0]?.html]),
        where,
      ).toEqual([])
    }
    await lab.paste(OBLONG_ASC)
    await page.getByTestId('crop-x').fill('9')
    await page.getByTestId('crop-x').press('Tab')
    await expectClean('import')
    await page.getByTestId('crop-whole').click()
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    await lab.menu('map-menu', 'open-resize')
    await expectClean('surface')
    await page.getByTestId('model-slices').click()
    await expectClean('slices')
    await page.getByTestId('resize').click()
    await expect(page.getByTestId('panel-1').getByRole('alert')).toBeVisible()
    await expectClean('refused')
    await lab.menu('map-menu', 'open-generate')
    await page.getByTestId('generate-hills').click()
    await expectClean('generate')
  })
}

test('on a phone the dialog of a raster fits and can be used by touch @phone', async ({ page }) => {
  const lab = new Lab(page)
  await lab.openAtRest()
  await lab.paste(ASC)
  const box = await dialog(page).boundingBox()
  expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= 390).toBe(true)
  const wide = await dialog(page).evaluate((element) => element.scrollWidth - element.clientWidth)
  expect(wide).toBe(0)
  await page.getByTestId('crop-height').fill('3')
  await page.getByTestId('crop-height').blur()
  await page.getByTestId('terrain-open').tap()
  await expect(dialog(page)).toBeHidden()
  expect((await scenarioOf(lab)).heights?.length).toBe(18)
})
