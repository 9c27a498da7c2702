/** Best known values: the page repeats what the tracker keeps, and the command line what the page shares. */
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { RacePage } from './race_page'
import { cli, submit, trackerOf } from './tracker_folder'

const entries = join(__dirname, '../../experiments/tracker/entries')

/** A plane with all its cells, several goals, and two terrains that travel as their generator call. */
const SAMPLES = [
  'threshold-1/ant-system',
  'ship-20x20/ship',
  'fire-20x20/fire',
  'hills-20/acs-slices',
  'hills-64-surface/terrain-epf',
]

function linkOf(entry: string): string {
  const text = readFileSync(join(entries, `${entry}.toml`), 'utf8')
  return /^session = "(#x=[\w-]+)"$/m.exec(text)?.[1] ?? ''
}

test.describe('the tracker', () => {
  for (const entry of SAMPLES)
    test(`its link ${entry} opens and is verified`, async ({ page }) => {
      await page.goto(`./${linkOf(entry)}`)
      await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
      const { panels } = await new RacePage(page).session()
      expect(panels.map(({ planner }) => planner)).toEqual([entry.split('/')[1]])
    })

  test('its links are short enough for any host', () => {
    for (const folder of readdirSync(entries))
      for (const file of readdirSync(join(entries, folder)))
        expect(linkOf(`${folder}/${file.replace(/\.toml$/, '')}`).length).toBeLessThan(8000)
  })

  for (const [map, what] of [
    [null, 'a map with all its cells'],
    ['gallery-random-100', 'a generated map with edits'],
  ])
    test(`takes a link of the page on ${what}`, async ({ page }) => {
      test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')
      const race = new RacePage(page)
      await race.openAtRest()
      if (map) {
        await race.menu('map-menu', map)
        await expect(page.getByTestId(map)).toHaveAttribute('aria-checked', 'true')
        await race.ready()
        await race.drag([
          [50, 50],
          [55, 50],
        ])
      }
      await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
      const link = await race.shareLink()
      const folder = trackerOf((await race.session()).scenario)
      const first = submit(folder, link)
      expect(first.said).toContain('the first value of this planner here')
      expect(first.code).toBe(0)
      const again = submit(folder, link)
      expect(again.said).toContain('equal to the best known')
      expect(again.code).toBe(0)
    })
})
