import { expect, test } from '@playwright/test'
import { profileOf } from '../../www/src/charts/profile_data'
import { Ground } from '../../www/src/model/relief_ground'
import { openTerrain } from './terrain_page'
import { drawn } from './workers'

test.describe('the elevation profile', () => {
  for (const id of ['terrain-hills', 'terrain-slices'] as const) {
    test(`has the numbers of the comparison (${id})`, async ({ page }) => {
      const race = await openTerrain(page, id)
      await page.getByTestId('chart-profile').click()
      await expect(page.getByTestId('profile')).toBeHidden()
      await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
      await expect(page.getByTestId('profile').locator('canvas')).toBeVisible()
      const { spec, heights } = await page.evaluate(() => {
        const now = window.formicarium.session()?.scenario
        if (!now?.heights) throw new Error('there is no terrain')
        return { spec: now.spec, heights: Array.from(now.heights) }
      })
      const ground = new Ground({
        spec,
        heights: Float32Array.from(heights),
        cells: new Uint8Array(),
        factors: null,
        origin: null,
      })
      const { path, summary } = await race.result(1)
      const terrain = summary?.metrics?.terrain
      const known = [summary?.metrics?.length_metres, terrain?.climb, terrain?.descent]
      const told = async () => {
        const label = (await page.getByTestId('profile').getAttribute('aria-label')) ?? ''
        const [, ...all] = /: ([\d.,]+) m long, ([\d.,]+) m up, ([\d.,]+) m down/.exec(label) ?? []
        return all.map((metres) => Number(metres.replaceAll(',', '')))
      }
      // Numbers come to the page a moment after the run has them.
      for (const [i, metres = Number.NaN] of known.entries())
        await expect.poll(async () => (await told())[i]).toBeCloseTo(metres, 1)
      if (id === 'terrain-slices') return
      const flat = Uint32Array.from((path ?? []).flat())
      const { altitudes } = profileOf(flat, new Float64Array(flat.length / 2), ground, false)
      const climb = altitudes.reduce(
        (sum, h, i) => sum + Math.max(0, h - (altitudes[i - 1] ?? h)),
        0,
      )
      expect(climb).toBeCloseTo(terrain?.climb ?? Number.NaN, 3)
    })
  }

  test('marks on the map where the pointer is, and its tabs work by keys', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    await page.getByTestId('chart-convergence').focus()
    await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('chart-profile')).toBeFocused()
    await expect(page.getByTestId('chart-profile')).toHaveAttribute('aria-selected', 'true')
    const plot = page.getByTestId('profile').locator('.u-over')
    await expect(plot).toBeVisible()
    await drawn(page)
    await race.seesMotion(1, () => plot.hover())
  })
})
