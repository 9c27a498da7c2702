/** Real maps of the MovingAI collection, where they are at hand: FORMICARIUM_DATA names the folder that holds them. */
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { expect, test } from '@playwright/test'
import { RacePage } from './race_page'

const folder = process.env.FORMICARIUM_DATA ?? ''

/** Finds a file by its name, however the collection is unpacked. */
function find(name: string): string | null {
  if (folder === '' || !existsSync(folder)) return null
  const found = readdirSync(folder, { recursive: true, encoding: 'utf8' }).find(
    (path) => basename(path) === name,
  )
  return found ? join(folder, found) : null
}

function read(name: string): Buffer {
  const path = find(name)
  test.skip(path === null, `needs ${name}: set FORMICARIUM_DATA to a folder that holds it`)
  return readFileSync(path ?? '')
}

test('Berlin_0_256.map imports and is solved', async ({ page }) => {
  const map = read('Berlin_0_256.map')
  const race = new RacePage(page)
  await race.openAtRest()
  await race.importByButton('Berlin_0_256.map', map)
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(256)
  await race.ready()
  await page.getByTestId('play').click()
  await race.reportPageThread('two panels on Berlin_0_256')
  await race.setSpeed(8)
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal', {
    timeout: 20_000,
  })
})

test('arena2.map with its .scen: the search finds the listed optimum', async ({ page }) => {
  const map = read('arena2.map')
  const scen = read('arena2.map.scen')
  const race = new RacePage(page)
  await race.openAtRest()
  const before = (await race.session()).scenario.spec.width
  await race.importByButton('arena2.map', map)
  await expect.poll(async () => (await race.session()).scenario.spec.width).not.toBe(before)
  await race.ready()
  await race.importByButton('arena2.map.scen', scen)
  const row = 200
  const line = scen.toString('utf8').trim().split(/\r?\n/)[row]
  const listed = Number(line?.trim().split(/\s+/).at(-1))
  await page.getByTestId('scen-dialog').getByRole('row').nth(row).getByRole('button').click()
  await race.ready()
  await expect
    .poll(async () => Number(await page.getByTestId('optimum').getAttribute('data-value')))
    .toBeCloseTo(listed, 3)
})
