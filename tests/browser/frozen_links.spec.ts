/** What earlier versions saved opens, shows what it showed, and comes out again or says why not. tests/fixtures/links/README.md. */
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'

const folder = join(__dirname, '../fixtures/links')
const read = (path: string) => readFileSync(join(folder, path))

interface Sample {
  /** Below the folder, without its ending. */
  path: string
  /** Of every panel its planner, and what the page says of its result. */
  panels: [planner: string, verified: 'verified' | 'differs'][]
  size: [width: number, height: number]
  goals: { name: string; danger: number; area: number }[]
  /** A height, where it is a terrain. */
  height?: number
}

const SESSIONS: Sample[] = [
  {
    path: 'b298a60/plane-one-goal',
    panels: [
      ['ant-system', 'verified'],
      ['astar', 'verified'],
      // Its path is refined by default since.
      ['ship', 'differs'],
    ],
    size: [16, 10],
    goals: [{ name: 'berth', danger: 1, area: 1 }],
  },
  {
    path: '34386b4/plane-weighted-goals',
    panels: [
      ['fire', 'verified'],
      ['tour-exact', 'verified'],
    ],
    size: [16, 10],
    goals: [
      { name: 'east', danger: 1, area: 2 },
      { name: 'middle', danger: 1, area: 1 },
    ],
  },
  {
    path: 'ae9355b/terrain-surface',
    panels: [
      ['ant-system', 'verified'],
      ['astar', 'verified'],
    ],
    size: [16, 10],
    goals: [{ name: 'berth', danger: 1, area: 1 }],
    // Column 3, row 1 of the maker's hills: (21 + 13 + 9) mod 40, in decimetres.
    height: 0.3,
  },
  {
    path: '0.1.0/session',
    panels: [
      ['ant-system', 'verified'],
      ['astar', 'verified'],
    ],
    size: [36, 22],
    goals: [{ name: 'goal', danger: 1, area: 1 }],
  },
]

/** Drops a file of the samples on the page. */
async function drop(page: Page, path: string): Promise<void> {
  const transfer = await page.evaluateHandle(
    ([name, base64]) => {
      const data = new DataTransfer()
      const bytes = Uint8Array.from(atob(base64 ?? ''), (char) => char.charCodeAt(0))
      data.items.add(new File([bytes], name ?? ''))
      return data
    },
    [path.split('/').at(-1), read(path).toString('base64')],
  )
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer })
}

async function shows(page: Page, sample: Sample): Promise<void> {
  const race = new RacePage(page)
  for (const [at, [, verified]] of sample.panels.entries())
    await expect(page.getByTestId(`verified-${at + 1}`)).toHaveAttribute('data-verified', verified)
  const { scenario, panels } = await race.session()
  expect([scenario.spec.width, scenario.spec.height]).toEqual(sample.size)
  expect(panels.map(({ planner }) => planner)).toEqual(sample.panels.map(([planner]) => planner))
  expect(scenario.spec.goals.map(({ name, danger, area }) => ({ name, danger, area }))).toEqual(
    sample.goals,
  )
  const height = scenario.heights?.[scenario.spec.width + 3]
  expect(height).toBe(sample.height === undefined ? undefined : Math.fround(sample.height))
}

test.describe('sessions of earlier versions', () => {
  for (const sample of SESSIONS) {
    for (const ending of ['link', 'experiment.json', 'png']) {
      const path = `${sample.path}.${ending}`
      if (!existsSync(join(folder, path))) continue
      test(`${path} opens`, async ({ page }) => {
        if (ending === 'link') await page.goto(`./${read(path).toString().trim()}`)
        else {
          await new RacePage(page).open()
          await drop(page, path)
        }
        await shows(page, sample)
      })
    }
  }
})

test.describe('comparisons of earlier versions', () => {
  for (const ending of ['link', 'result.json', 'png']) {
    const path = `0.1.0/study.${ending}`
    test(`${path} opens and is verified`, async ({ page }) => {
      if (ending === 'link') await page.goto(`./${read(path).toString().trim()}`)
      else {
        await new RacePage(page).open()
        await drop(page, path)
      }
      await expect(page.getByTestId('run-bar')).toContainText('Frozen: two maps, three planners')
      await expect(page.getByTestId('verification-recorded')).toHaveText(
        'Recorded with engine 0.1.0: 30 runs.',
      )
      // Runs of a file and of a picture are there at once.
      const rows = await page.evaluate(() => window.formicarium.resultFile('csv'))
      expect(rows.trim().split('\n')).toHaveLength(ending === 'link' ? 1 : 1 + 30)
      await page.getByTestId('verify-again').click()
      await expect(page.getByTestId('verification')).toHaveAttribute('data-state', 'same')
    })
  }
})

test('every sample is opened by a test', () => {
  const known = new Set(SESSIONS.map(({ path }) => path).concat('0.1.0/study', '0.1.0/question'))
  const all = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((file) => file.isFile() && !['make.mjs', 'README.md'].includes(file.name))
    .map(({ parentPath, name }) => `${parentPath.slice(folder.length + 1)}/${name}`)
  expect(all.length).toBeGreaterThanOrEqual(13)
  for (const path of all) expect(known).toContain(path.replace(/\.(link|png|\w+\.json|json)$/, ''))
})
