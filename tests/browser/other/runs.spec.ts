/** The same page and the same runs, bit for bit, in the other browsers. */
import { expect } from '@playwright/test'
import type { Race } from '../race'
import { RacePage } from '../race_page'
import { test } from './browsers'
import { hearing } from './ear'

/** A planner that only the whole engine has. */
const LATER = 'option[value="max-min-ant-system"]'

test('the page opens, and nothing is reported to the console as an error', async ({
  other,
  baseURL,
}) => {
  console.log(`in ${other.name}`)
  const { race } = other
  const ear = await hearing(baseURL ?? '')
  await race.open(ear.address)
  // The search counts each expanded cell, and ants step together with it.
  const expanded = async () => (await race.result(2)).summary?.effort.cell_expansions
  await expect.poll(expanded).toBeGreaterThan(0)
  const later = () => race.evaluate((option) => document.querySelector(option) !== null, LATER)
  await expect.poll(later).toBe(true)
  const complaints = () => race.ask(() => window.complaints)
  expect(await complaints()).toEqual([])
  await race.ask(() => console.error('this one is heard'))
  expect(await complaints()).toEqual(['this one is heard'])
  ear.close()
})

test('the opening race ends as in Chromium', async ({ other, page }) => {
  const chromium = new RacePage(page)
  await chromium.openAtRest()
  await other.race.openAtRest()
  const digests = await finish(chromium)
  expect(digests).toEqual([expect.stringMatching(/^[0-9a-f]{16}$/), expect.any(String)])
  expect(await finish(other.race)).toEqual(digests)
})

test('a link from Chromium opens verified', async ({ other, page }) => {
  const chromium = new RacePage(page)
  await chromium.openAtRest()
  await finish(chromium)
  await opensVerified(other.race, await chromium.shareLink())
})

test('a link opens verified in Chromium', async ({ other, page }) => {
  const { race } = other
  await race.openAtRest()
  await finish(race)
  await race.press('share')
  const link = () =>
    race.ask(() => document.querySelector<HTMLInputElement>('[data-testid="share-link"]')?.value)
  await expect.poll(link).toMatch(/#x=/)
  await opensVerified(new RacePage(page), (await link()) ?? '')
})

/** Runs every panel to its end; their digests. */
async function finish(race: Race): Promise<unknown[]> {
  return race.ask(async () =>
    (await window.formicarium.run()).map(({ summary }) => summary?.digest),
  )
}

async function opensVerified(race: Race, link: string): Promise<void> {
  await race.open(link)
  for (const panel of ['verified-1', 'verified-2'])
    await expect.poll(() => race.attribute(panel, 'data-verified')).toBe('verified')
}
