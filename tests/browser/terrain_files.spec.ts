import { expect, test } from '@playwright/test'
import { RacePage } from './race_page'
import { ASC, CSV, geotiff, HEIGHTS, hgt, KNOWN, OBLONG_ASC } from './rasters'
import { dialog, expectHeights, scenarioOf } from './terrain_page'

test.describe('rasters of heights', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  const files: [name: string, content: string | Buffer, kind: RegExp, heights: number[]][] = [
    ['small.asc', ASC, /ESRI/, KNOWN],
    ['dos.asc', ASC.replaceAll('\n', '\r\n'), /ESRI/, KNOWN],
    ['small.tif', geotiff(), /GeoTIFF/, KNOWN],
    ['small.csv', CSV, /Table/, HEIGHTS.flat().map((height) => Math.max(0, height))],
  ]
  for (const [name, content, kind, heights] of files) {
    test(`${name} is surveyed, then opened by Enter`, async ({ page }) => {
      const race = new RacePage(page)
      const walls = await race.walls()
      await race.importByButton(name, content)
      await expect(dialog(page)).toBeVisible()
      await expect(page.getByTestId('raster-kind')).toHaveText(kind)
      await expect(page.getByTestId('raster-size')).toHaveText('6 × 5')
      await expect(page.getByTestId('raster-heights')).toHaveText(/to 35/)
      expect(await race.walls()).toBe(walls)
      await page.keyboard.press('Enter')
      await expect(dialog(page)).toBeHidden()
      await expectHeights(race, heights)
      const { spec, cells } = await scenarioOf(race)
      expect([...cells]).toEqual(heights.map((height) => (Number.isNaN(height) ? 1 : 0)))
      expect(spec.terrain).toEqual({ vertical_unit: 1, max_slope: 90 })
      expect(spec.resolution).toBe(name === 'small.csv' ? 1 : 10)
      await race.ready()
      await page.locator('body').press('End')
      await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    })
  }

  test('dropped and pasted as well, and left with Escape', async ({ page }) => {
    const race = new RacePage(page)
    const before = await scenarioOf(race)
    for (const bring of [
      () => race.drop('small.asc', ASC),
      () => race.paste(ASC),
      () => race.paste(CSV),
    ]) {
      await bring()
      await expect(dialog(page)).toBeVisible()
      await page.keyboard.press('Escape')
      await expect(dialog(page)).toBeHidden()
    }
    expect(await scenarioOf(race)).toEqual(before)
  })

  test('a part can be marked by numbers, and comes exactly as it is', async ({ page }) => {
    const race = new RacePage(page)
    await race.paste(ASC)
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
      race,
      HEIGHTS.slice(1).flatMap((row) => row.slice(2, 5)),
    )
  })

  test('a part can be marked by dragging', async ({ page }) => {
    await new RacePage(page).paste(ASC)
    const preview = page.getByTestId('raster-preview')
    await expect(preview).toBeVisible()
    const box = await preview.boundingBox()
    if (!box) throw new Error('there is no picture')
    const at = (x: number, y: number) =>
      [box.x + (box.width * x) / 6, box.y + (box.height * y) / 5] as const
    await page.mouse.move(...at(4.5, 3.5))
    await page.mouse.down()
    await page.mouse.move(...at(2.5, 2))
    await page.mouse.move(...at(1.5, 0.5))
    await page.mouse.up()
    for (const [field, value] of [
      ['crop-x', '1'],
      ['crop-y', '0'],
      ['crop-width', '4'],
      ['crop-height', '4'],
    ] as const)
      await expect(page.getByTestId(field)).toHaveValue(value)
    await page.getByTestId('crop-whole').click()
    await expect(page.getByTestId('raster-crop')).toBeHidden()
    await expect(page.getByTestId('crop-width')).toHaveValue('6')
  })

  test('cells that are not square are made so unless the reader says otherwise, and the extent stays', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.paste(OBLONG_ASC)
    await expect(page.getByTestId('raster-cell')).toHaveText('15 × 30 m')
    await expect(page.getByTestId('raster-result')).toContainText('30 × 30 m')
    await page.getByTestId('size-square').click()
    await expect(page.getByTestId('raster-result')).toContainText('15 × 30 m')
    await expect(page.getByTestId('raster-result')).toContainText('lengths will be off')
    await page.getByTestId('size-square').click()
    // A side that is typed takes the other one along.
    await page.getByTestId('size-width').fill('6')
    await page.getByTestId('size-width').press('Tab')
    await expect(page.getByTestId('size-height')).toHaveValue('10')
    await page.getByTestId('size-full').click()
    await expect(page.getByTestId('size-width')).toHaveValue('3')
    await expect(page.getByTestId('size-height')).toHaveValue('5')
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden()
    const { spec } = await scenarioOf(race)
    expect([spec.width, spec.height, spec.resolution]).toEqual([3, 5, 30])
  })

  test('a large survey is offered in as many cells as can be watched', async ({ page }) => {
    test.slow()
    const race = new RacePage(page)
    await race.importByButton('N40W106.hgt', hgt())
    await expect(page.getByTestId('raster-size')).toHaveText('1,201 × 1,201')
    await expect(page.getByTestId('size-height')).toHaveValue('513')
    await page.getByTestId('size-256').click()
    await expect(page.getByTestId('size-height')).toHaveValue('256')
    const columns = async () => Number(await page.getByTestId('size-width').inputValue())
    // At 40° north a second of arc is shorter from west to east.
    const share = Math.cos((40.5 * Math.PI) / 180)
    await expect.poll(async () => (await columns()) / 256).toBeCloseTo(share, 1)
    const width = await columns()
    await page.getByTestId('terrain-open').click()
    await expect(dialog(page)).toBeHidden({ timeout: 30_000 })
    const { spec, heights } = await scenarioOf(race)
    expect([spec.width, spec.height]).toEqual([width, 256])
    expect(heights?.at(-1) ?? 0).toBeGreaterThan(2300)
  })

  test('what cannot be read is refused where the reader looks, and nothing on screen is lost', async ({
    page,
  }) => {
    const race = new RacePage(page)
    const before = await scenarioOf(race)
    const spoilt: [string, string | Buffer][] = [
      ['short.asc', ASC.split('\n').slice(0, -3).join('\n')],
      ['letters.asc', ASC.replace('30 35 30', '30 x 30')],
      ['huge.asc', ASC.replace('ncols 6', 'ncols 60000').replace('nrows 5', 'nrows 60000')],
      ['cut.tif', geotiff().subarray(0, 190)],
      ['cut.hgt', hgt().subarray(0, 10_000)],
    ]
    for (const [name, content] of spoilt) {
      await race.importByButton(name, content)
      const alert = page.getByTestId('import-dialog').getByRole('alert')
      await expect(alert, name).toBeVisible()
      expect((await alert.textContent())?.length, name).toBeGreaterThan(30)
      await page.keyboard.press('Escape')
    }
    await race.paste(ASC.replace('30 35 30', '30 x 30'))
    await expect(page.getByTestId('toast-error')).toContainText('9')
    expect(await scenarioOf(race)).toEqual(before)
  })

  test('scripts say which part of the raster they want, and are not asked', async ({ page }) => {
    const race = new RacePage(page)
    const opened = await page.evaluate((text) => window.formicarium.load(text, { part: {} }), ASC)
    expect(opened.kind).toBe('map')
    await expectHeights(race, KNOWN)
  })
})
