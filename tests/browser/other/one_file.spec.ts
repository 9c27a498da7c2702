/** Pages of one file that Chromium has saved, in the other browsers: from their folder, and where they may keep and reach nothing. */
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { fileURLToPath } from 'node:url'
import { expect, type Page } from '@playwright/test'
import type { Race } from '../race'
import { RacePage } from '../race_page'
import { savedPage } from '../saved_pages'
import { test } from './browsers'

/** The address of a race that has run a little. */
async function racePage(page: Page): Promise<string> {
  await new RacePage(page).openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  await page.getByTestId('share').click()
  return savedPage(page, 'share-page', 'race.html')
}

async function opensVerified(race: Race, address: string): Promise<void> {
  await race.open(address)
  for (const panel of ['verified-1', 'verified-2'])
    await expect.poll(() => race.attribute(panel, 'data-verified')).toBe('verified')
}

test('a page of one file opens by file://, verified', async ({ other, page }) => {
  console.log(`in ${other.name}`)
  await opensVerified(other.race, await racePage(page))
})

test('it runs as a sandboxed frame does: without an origin', async ({ other, page }) => {
  const file = readFileSync(fileURLToPath(await racePage(page)))
  const server = createServer((_, answer) => {
    answer.setHeader('Content-Type', 'text/html')
    answer.setHeader('Content-Security-Policy', 'sandbox allow-scripts')
    answer.end(file)
  }).listen(0)
  const { port } = server.address() as AddressInfo
  await opensVerified(other.race, `http://localhost:${port}/`)
  expect(await other.race.ask(() => self.origin)).toBe('null')
  server.close()
})
