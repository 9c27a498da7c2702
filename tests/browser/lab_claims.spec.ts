/** What became of claims, over maps and on each of them. */
import AxeBuilder from '@axe-core/playwright'
import { expect, test } from '@playwright/test'
import { ResultsPage } from './results_page'

const SEEDS = 30
const MAPS = 8

const places = Array.from({ length: MAPS }, (_, i) => `map-${i}`)

/** Of map `i` every run of the old one is 20 long, and of the new one 5 + i % shorter. */
const given = (instance: number, entry: number, seed: number) => {
  const length = entry === 0 ? 20 : 19 - 0.2 * instance
  return {
    task: { instance, entry, seed },
    status: 'budget-spent',
    found: { length, turns: null, turn_index: null, weight: null, value: length },
    effort: [null, null, null, null],
    trace: [],
    digest: '',
  }
}

/** Eight corridors, of which the last one cannot stand for the publication's. */
const asked = {
  format: 'formicarium/comparison@1',
  question: {
    format: 'formicarium/question@1',
    title: 'Claims over maps',
    asks: '?',
    seeds: { from: 1, count: SEEDS },
    instances: places.map((id) => ({ id, map: 'm.json', group: 'corridor' })),
    entries: [
      { id: 'old', label: 'Old', role: 'baseline', results: 'old.csv' },
      { id: 'new', label: 'New', role: 'improved', results: 'new.csv' },
      { id: 'exact', label: 'A*', role: 'other', planner: 'astar' },
    ],
    claims: ['length', 'running-time'].map((measure) => ({
      id: measure,
      says: measure === 'length' ? 'shorter paths' : 'sooner',
      improved: 'new',
      baseline: 'old',
      measure,
      direction: 'less',
      ...(measure === 'length' && { size: 0.1 }),
    })),
    facts: [{ instances: ['map-7'], optimum_at_most: 9.5, says: 'table 1' }],
  },
  maps: places.map((name) => ({
    format: 'formicarium/scenario@1',
    name,
    width: 11,
    height: 1,
    start: [0, 0],
    goals: [{ at: [10, 0] }],
    map: { rows: ['...........'] },
  })),
  given: places.flatMap((_, instance) =>
    [0, 1].flatMap((entry) =>
      Array.from({ length: SEEDS }, (_, i) => given(instance, entry, i + 1)),
    ),
  ),
}

const document = JSON.stringify(asked)

/** The first claim by two readings, the second one by none. */
function withReadings(): string {
  const [length, time] = asked.question.claims
  const claims = [
    { ...length, reading: 'printed' },
    { ...length, id: 'length-second', size: 0.3, reading: 'second-reading' },
    time,
  ]
  return JSON.stringify({ ...asked, question: { ...asked.question, claims } })
}

test.describe('claims over maps', () => {
  test('a claim is told over its maps, and unfolds to each', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(document)
    await results.tab('reported')
    const claim = page.getByTestId('claim-length')
    await expect(claim.locator('tr')).toHaveCount(1)
    await expect(claim).toContainText('7 of 7 maps')
    await expect(claim).toContainText('Reproduced')
    await expect(claim).toContainText('matters from')
    await expect(claim).toContainText('for 7, against 0, level 0; sign test p 0.016')
    const unfold = page.getByTestId('claim-maps-length')
    await expect(unfold).toHaveAttribute('aria-expanded', 'false')
    await unfold.focus()
    await page.keyboard.press('Enter')
    await expect(unfold).toHaveAttribute('aria-expanded', 'true')
    await expect(claim.locator('.claim-map')).toHaveCount(MAPS)
    await expect(claim.getByRole('row', { name: /^map-7/ })).toContainText(
      'the map contradicts what the publication says of its own',
    )
    await expect(page.getByTestId('claim-running-time')).toContainText('too few maps')
    const { violations } = await new AxeBuilder({ page }).include('.results').analyze()
    expect(violations).toEqual([])
  })

  test('maps that cannot stand for the paper’s are listed with the reason', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(document)
    await results.tab('reported')
    const unfit = page.getByTestId('unfit')
    await expect(unfit.getByRole('listitem')).toHaveText([
      'map-7: the exact optimum is 10.00; published is 9.5 (table 1)',
    ])
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(unfit.getByRole('listitem')).toHaveText([
      'map-7：精确最优为 10.00，论文报告 9.5（表 1）',
    ])
    await expect(page.getByTestId('claim-length')).toContainText('7 张地图中的 7 张')
  })

  test('files tell the same', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(document)
    const csv = await results.file('claims-csv')
    const lines = csv.trim().split('\n')
    expect(lines).toHaveLength(1 + 2 * MAPS + 2)
    expect(lines[1 + 2 * MAPS]).toMatch(/^,length,new,old,.*,reproduced,$/)
    expect(await results.file('markdown')).toContain('| 7 of 7 maps [65 %, 100 %] |')
  })
})

test.describe('claims by reading', () => {
  test('all stand side by side first, and the switch shows those of one', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(withReadings())
    await results.tab('reported')
    const table = page.getByTestId('claims-by-reading')
    await expect(table.getByRole('columnheader')).toHaveText([
      'Claim',
      'as printed',
      'second reading',
    ])
    await expect(table.getByRole('row')).toHaveCount(2)
    await expect(table.getByRole('cell')).toHaveText([
      /^Reproduced7 of 7 maps-10\.0% \(-10\.0% to -5\.0%\)$/,
      /^Partly7 of 7 maps/,
    ])
    const all = page.getByTestId('verdicts').locator('tbody')
    await expect(all).toHaveCount(3)
    await expect(page.getByTestId('claim-length')).toContainText('as printed')
    const { violations } = await new AxeBuilder({ page }).include('.results').analyze()
    expect(violations).toEqual([])
    // By keys, as every radio group.
    await page.getByTestId('claims-reading-all').focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('claims-reading-second-reading')).toBeChecked()
    await expect(table).toHaveCount(0)
    await expect(all).toHaveCount(1)
    await expect(page.getByTestId('claim-length-second')).toBeVisible()
  })

  test('the choice is kept while the page is open', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(withReadings())
    await results.tab('reported')
    await page.getByTestId('claims-reading-printed').check()
    await results.tab('summary')
    await results.tab('reported')
    await expect(page.getByTestId('claims-reading-printed')).toBeChecked()
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(page.getByTestId('claims-reading').locator('label')).toHaveText([
      '全部',
      '按印刷公式',
      '第二种读法',
    ])
  })

  test('a question without readings has no switch', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(document)
    await results.tab('reported')
    await expect(page.getByTestId('verdicts')).toBeVisible()
    await expect(page.getByTestId('claims-reading')).toHaveCount(0)
    await expect(page.getByTestId('claims-by-reading')).toHaveCount(0)
  })

  test('files tell of the readings', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(withReadings())
    const lines = (await results.file('claims-csv')).trim().split('\n')
    expect(lines[0]).toMatch(/,reading$/)
    expect(lines[1]).toMatch(/,printed$/)
    expect(await results.file('markdown')).toContain('## Claims by reading')
  })
})
