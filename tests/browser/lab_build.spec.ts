import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import type { ComparisonDocument } from '../../www/src/model/comparison'
import { ComparisonPage } from './comparison_page'
import { RacePage } from './race_page'

/** What was asked, by the result file of the comparison that is open. */
async function asked({ page }: ComparisonPage): Promise<ComparisonDocument['question']> {
  const text = await page.evaluate(() => window.formicarium.resultFile('link'))
  return (JSON.parse(text) as ComparisonDocument).question
}

test.describe('making a comparison', () => {
  test('from maps, planners, values, seeds and a budget', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.on('aco-20x20', 'open-field')
    await comparison.compare('ant-system', 'ant-system', 'ship')
    await comparison.set(2, 'ants', 7)
    await comparison.entry(3).getByTestId('entry-label').fill('Ours')
    await comparison.seeds(2, 40)
    await page.getByTestId('budget-axis').selectOption('constructed-paths')
    await comparison.type('budget-amount', 60)
    await page.getByTestId('study-title').fill('Three of them')
    await expect(page.getByTestId('run-count')).toHaveText(
      /2 maps × 3 planners × 2 seeds = 12 runs/,
    )
    await comparison.run()
    await comparison.finished()
    const question = await asked(comparison)
    expect(question.title).toBe('Three of them')
    expect(question.seeds).toEqual({ from: 40, count: 2 })
    expect(question.budget).toEqual({ axis: 'constructed-paths', amount: 60 })
    expect(question.instances.map(({ id }) => id)).toEqual(['classic-20-20', 'open-field'])
    const entries = question.entries.map(({ id, label, set }) => [id, label, set])
    expect(entries).toEqual([
      ['ant-system', 'Ant System · m 50', {}],
      ['ant-system-2', 'Ant System · m 7', { ants: 7 }],
      ['ship', 'Ours', {}],
    ])
    const csv = await page.evaluate(() => window.formicarium.resultFile('csv'))
    expect(csv.trim().split('\n')).toHaveLength(1 + 12)
  })

  test('lets every planner go on until the budget is spent', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ant-system', 'astar')
    await comparison.seeds(1)
    await page.getByTestId('budget-axis').selectOption('iterations')
    await comparison.type('budget-amount', 130)
    const iterations = async () => {
      await comparison.run()
      await comparison.finished()
      const json = await page.evaluate(() => window.formicarium.resultFile('json'))
      const [ants] = JSON.parse(json).rows as { effort: number[] }[]
      await page.getByTestId('lab-back').click()
      return ants?.effort[0]
    }
    // A hundred iterations are what Ant System takes by itself.
    expect(await iterations()).toBe(100)
    await page.getByTestId('until-budget').check()
    expect(await iterations()).toBe(130)
  })

  test('tells what the engine refuses at the field that it names', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('astar', 'ant-system')
    await comparison.set(2, 'rho', 1.5)
    await comparison.start.click()
    const error = comparison.entry(2).locator('.field-error')
    await expect(error).toContainText('1.5')
    await expect(comparison.entry(2).getByTestId('param-rho')).toHaveAttribute(
      'aria-invalid',
      'true',
    )
    await expect(comparison.entry(1).locator('.field-error')).toBeHidden()
    await comparison.set(2, 'rho', 0.5)
    await expect(error).toBeHidden()
    await comparison.seeds(2)
    await comparison.run()
    await comparison.finished()
  })

  test('says which planner does not fit which map', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('astar', 'ship')
    await comparison.on('two-corridors', 'terrain-hills')
    await expect(comparison.entry(2)).toContainText('Hills')
    await expect(comparison.entry(1).locator('.remark')).toBeHidden()
    await page.getByTestId('lab-add-planner').click()
    await expect(page.getByTestId('lab-add-ship')).toHaveAttribute('aria-disabled', 'true')
  })

  test('takes maps from files, and says why it does not', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const file = page.getByTestId('lab-map-file')
    await file.setInputFiles({
      name: 'mine.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from('0 0 0\n0 1 0\n0 0 0\n'),
    })
    await expect(comparison.maps).toHaveCount(2)
    await expect(comparison.maps.last()).toContainText('3 × 3')
    await file.setInputFiles({
      name: 'rubbish.bin',
      mimeType: 'application/octet-stream',
      buffer: Buffer.from([0, 255, 1, 254]),
    })
    await expect(page.getByTestId('builder').getByRole('alert')).toBeVisible()
    await expect(comparison.maps).toHaveCount(2)
  })

  test('looks first at files that leave a choice, and leaves the race as it is', async ({
    page,
  }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const before = await new RacePage(page).session()
    const yaml =
      'image: small.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'
    const gray = Buffer.from([254, 254, 205, 254, 0, 254, 254, 254, 254])
    const file = (name: string, content: string | Buffer) => ({
      name,
      mimeType: 'application/octet-stream',
      buffer: Buffer.from(content),
    })
    await page
      .getByTestId('lab-map-file')
      .setInputFiles([
        file('small.yaml', yaml),
        file('small.pgm', Buffer.concat([Buffer.from('P5\n3 3\n255\n'), gray])),
        file('north.asc', 'ncols 2\nnrows 3\ndx 30\ndy 10\n1 2\n3 4\n5 6\n'),
      ])
    await expect(page.getByTestId('map-dialog')).toBeVisible()
    await page.getByTestId('map-open').click()
    await expect(page.getByTestId('terrain-dialog')).toBeVisible()
    await page.getByTestId('terrain-open').click()
    await expect(comparison.maps).toHaveCount(3)
    await expect(comparison.maps.nth(1)).toContainText('3 × 3')
    expect((await new RacePage(page).session()).scenario.spec).toEqual(before.scenario.spec)
  })

  test('an ablation is one click', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ship')
    await comparison.entry(1).getByTestId('ablate').click()
    await expect.poll(() => comparison.entries.count()).toBeGreaterThan(1)
    await comparison.seeds(2)
    await comparison.run()
    await comparison.finished()
    const question = await asked(comparison)
    expect(question.entries[0]).toMatchObject({ id: 'full', role: 'improved', planner: 'ship' })
    for (const { id, set } of question.entries.slice(1)) {
      expect(id).toMatch(/^without-/)
      expect(Object.keys(set ?? {}).length).toBeGreaterThan(0)
    }
    expect(question.title).toMatch(/^Ablation of /)
  })

  test('an earlier one is the beginning of the next', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.on('aco-20x20')
    await comparison.compare('ant-system', 'astar')
    await comparison.set(1, 'ants', 9)
    await comparison.seeds(2, 5)
    await comparison.run()
    await comparison.finished()
    const before = await asked(comparison)
    await page.getByTestId('lab-change').click()
    await comparison.ready()
    await comparison.add('dijkstra')
    await comparison.run()
    await comparison.finished()
    const after = await asked(comparison)
    expect(after.entries.slice(0, 2)).toEqual(before.entries)
    expect(after.entries).toHaveLength(3)
    expect([after.seeds, after.instances]).toEqual([before.seeds, before.instances])
  })

  test('everything can be done with the keyboard alone', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.openFromRace()
    await page.getByTestId('lab-add-planner').focus()
    await page.keyboard.press('Enter')
    await page.keyboard.press('End')
    await page.keyboard.press('Home')
    await page.keyboard.press('Enter')
    await expect(comparison.entries).toHaveCount(3)
    await page.getByTestId('seed-count').focus()
    await page.keyboard.press('Control+a')
    await page.keyboard.type('2')
    await page.keyboard.press('Enter')
    await comparison.start.focus()
    await page.keyboard.press('Enter')
    await comparison.finished()
    await expect(page.getByTestId('run-bar').getByRole('heading')).toBeFocused()
  })
})

test('a file of the command line opens with its runs, and goes on where it was', async ({
  page,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  const result = await comparison.script({ seeds: 2 })
  await page.getByTestId('lab-back').click()
  const partly = JSON.parse(result.files.json)
  partly.rows.splice(1, 1)
  const open = page.getByTestId('lab-file')
  await open.setInputFiles({
    name: 'partly.json',
    mimeType: 'application/json',
    buffer: Buffer.from(JSON.stringify(partly)),
  })
  await expect.poll(() => comparison.phase()).toBe('paused')
  await expect.poll(() => comparison.done()).toBe(3)
  await page.getByTestId('lab-go-on').click()
  await comparison.finished()
  const again = await page.evaluate(() => window.formicarium.resultFile('csv'))
  expect(again).toBe(result.files.csv)

  await page.getByTestId('lab-back').click()
  await open.setInputFiles({
    name: 'newer.json',
    mimeType: 'application/json',
    buffer: Buffer.from(result.files.json.replace('comparison@1', 'comparison@9')),
  })
  await expect(page.locator('.lab-side').getByRole('alert')).toBeVisible()
})

test('a map that is dropped joins the comparison', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  const file = readFileSync(join(__dirname, '../../experiments/maps/ship-20x20.json'), 'utf8')
  await new RacePage(page).drop('ship.json', file)
  await expect(comparison.maps).toHaveCount(2)
  await expect(comparison.maps.last()).toContainText('20 × 20')
})
