/** Results measured by a weighted sum have a gap to what is proven by their own weights. */
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

const SUM = { criterion: 'weighted-sum', clearance_weight: 0 }
const PLAIN = { preset: null, label: null, result: null }

async function openSums(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.evaluate(
    async ([sum, plain]) => {
      const session = window.formicarium.session()
      if (!session) throw new Error('there is no session')
      const panels = [
        { ...plain, planner: 'turn-aware', params: { ...sum, turn_weight: 5 } },
        { ...plain, planner: 'fire', params: { ...sum, turn_weight: 5, iterations: 3 } },
        { ...plain, planner: 'turn-aware', params: { ...sum, turn_weight: 0 } },
      ]
      await window.formicarium.load({ ...session, panels })
    },
    [SUM, PLAIN] as const,
  )
  await race.ready()
  await page.getByTestId('run-to-end').click()
  await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
  return race
}

const gapOf = async (page: Page, place: number) => {
  const gap = page.getByTestId(`gap-${place}`)
  await expect(gap).toHaveAttribute('data-gap', /\d/)
  return Number(await gap.getAttribute('data-gap'))
}

test('each panel is held against the proven sum by its weights', async ({ page }) => {
  const race = await openSums(page)
  const [dear, ants, cheap] = (await race.results()).map(({ summary }) => summary)
  expect([dear?.objective, ants?.objective]).toEqual(['weighted', 'weighted'])
  const least = dear?.value ?? Number.NaN
  // By other weights it is another sum.
  expect(cheap?.value).toBeLessThan(least)
  expect([await gapOf(page, 1), await gapOf(page, 3)]).toEqual([0, 0])
  expect(await gapOf(page, 2)).toBeCloseTo(((ants?.value ?? 0) - least) / least, 9)
  await expect(page.getByTestId('gap-1')).toHaveText(/the smallest weighted sum/)
})

test('it is proven anew on another map', async ({ page }) => {
  const race = await openSums(page)
  const before = (await race.result(1)).summary?.value ?? 0
  await race.menu('map-menu', 'gallery-open-field')
  await race.ready()
  await page.getByTestId('run-to-end').click()
  await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
  expect(await gapOf(page, 1)).toBe(0)
  expect((await race.result(1)).summary?.value).not.toBe(before)
})
