import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import type { ComparisonDocument } from '../../www/src/model/comparison'
import { Lab } from './lab'
import { Laboratory } from './lab_page'

/** What was asked, by the result file of the comparison that is open. */
async function asked({ page }: Laboratory): Promise<ComparisonDocument['question']> {
  const text = await page.evaluate(() => window.formicarium.resultFile('link'))
  return (JSON.parse(text) as ComparisonDocument).question
}

test.describe('making a comparison', () => {
  test('from maps, planners, values, seeds and a budget', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.on('aco-20x20', 'open-field')
    await laboratory.compare('ant-system', 'ant-system', 'ship')
    await laboratory.set(2, 'ants', 7)
    await laboratory.entry(3).getByTestId('entry-label').fill('Ours')
    await laboratory.seeds(2, 40)
    await page.getByTestId('budget-axis').selectOption('constructed-paths')
    await laboratory.type('budget-amount', 60)
    await page.getByTestId('study-title').fill('Three of them')
    await expect(page.getByTestId('run-count')).toHaveText(
      /2 maps × 3 planners × 2 seeds = 12 runs/,
    )
    await laboratory.run()
    await laboratory.finished()
    const question = await asked(laboratory)
    expect(question.title).toBe('Three of them')
    expect(question.seeds).toEqual({ from: 40, count: 2 })
    expect(question.budget).toEqual({ axis: 'constructed-paths', amount: 60 })
    expect(question.instances.map(({ id }) => id)).toEqual(['classic-20-20', 'open-field'])
    const entries = question.entries.map(({ id, label, set }) => [id, label, set])
    expect(entries).toEqual([
      ['ant-system', 'Ant System', {}],
      ['ant-system-2', 'Ant System (ants 7)', { ants: 7 }],
      ['ship', 'Ours', {}],
    ])
    const csv = await page.evaluate(() => window.formicarium.resultFile('csv'))
    expect(csv.trim().split('\n')).toHaveLength(1 + 12)
  })

  test('lets every planner go on until the budget is spent', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.compare('ant-system', 'astar')
    await laboratory.seeds(1)
    await page.getByTestId('budget-axis').selectOption('iterations')
    await laboratory.type('budget-amount', 130)
    const iterations = async () => {
      await laboratory.run()
      await laboratory.finished()
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
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.compare('astar', 'ant-system')
    await laboratory.set(2, 'rho', 1.5)
    await laboratory.start.click()
    const error = laboratory.entry(2).locator('.field-error')
    await expect(error).toContainText('1.5')
    await expect(laboratory.entry(2).getByTestId('param-rho')).toHaveAttribute(
      'aria-invalid',
      'true',
    )
    await expect(laboratory.entry(1).locator('.field-error')).toBeHidden()
    await laboratory.set(2, 'rho', 0.5)
    await expect(error).toBeHidden()
    await laboratory.seeds(2)
    await laboratory.run()
    await laboratory.finished()
  })

  test('says which planner does not fit which map', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.compare('astar', 'ship')
    await laboratory.on('two-corridors', 'terrain-hills')
    await expect(laboratory.entry(2)).toContainText('Hills')
    await expect(laboratory.entry(1).locator('.remark')).toBeHidden()
    await page.getByTestId('lab-add-planner').click()
    await expect(page.getByTestId('lab-add-ship')).toHaveAttribute('aria-disabled', 'true')
  })

  test('takes maps from files, and says why it does not', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    const file = page.getByTestId('lab-map-file')
    await file.setInputFiles({
      name: 'mine.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from('0 0 0\n0 1 0\n0 0 0\n'),
    })
    await expect(laboratory.maps).toHaveCount(2)
    await expect(laboratory.maps.last()).toContainText('3 × 3')
    await file.setInputFiles({
      name: 'rubbish.bin',
      mimeType: 'application/octet-stream',
      buffer: Buffer.from([0, 255, 1, 254]),
    })
    await expect(page.getByTestId('builder').getByRole('alert')).toBeVisible()
    await expect(laboratory.maps).toHaveCount(2)
  })

  test('an ablation is one click', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.compare('ship')
    await laboratory.entry(1).getByTestId('ablate').click()
    await expect.poll(() => laboratory.entries.count()).toBeGreaterThan(1)
    await laboratory.seeds(2)
    await laboratory.run()
    await laboratory.finished()
    const question = await asked(laboratory)
    expect(question.entries[0]).toMatchObject({ id: 'full', role: 'improved', planner: 'ship' })
    for (const { id, set } of question.entries.slice(1)) {
      expect(id).toMatch(/^without-/)
      expect(Object.keys(set ?? {}).length).toBeGreaterThan(0)
    }
    expect(question.title).toMatch(/^Ablation of /)
  })

  test('an earlier one is the beginning of the next', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.open()
    await laboratory.on('aco-20x20')
    await laboratory.compare('ant-system', 'astar')
    await laboratory.set(1, 'ants', 9)
    await laboratory.seeds(2, 5)
    await laboratory.run()
    await laboratory.finished()
    const before = await asked(laboratory)
    await page.getByTestId('lab-change').click()
    await laboratory.ready()
    await laboratory.add('dijkstra')
    await laboratory.run()
    await laboratory.finished()
    const after = await asked(laboratory)
    expect(after.entries.slice(0, 2)).toEqual(before.entries)
    expect(after.entries).toHaveLength(3)
    expect([after.seeds, after.instances]).toEqual([before.seeds, before.instances])
  })

  test('everything can be done with the keyboard alone', async ({ page }) => {
    const laboratory = new Laboratory(page)
    await laboratory.openFromRace()
    await page.getByTestId('lab-add-planner').focus()
    await page.keyboard.press('Enter')
    await page.keyboard.press('End')
    await page.keyboard.press('Home')
    await page.keyboard.press('Enter')
    await expect(laboratory.entries).toHaveCount(3)
    await page.getByTestId('seed-count').focus()
    await page.keyboard.press('Control+a')
    await page.keyboard.type('2')
    await page.keyboard.press('Enter')
    await laboratory.start.focus()
    await page.keyboard.press('Enter')
    await laboratory.finished()
    await expect(page.getByTestId('run-bar').getByRole('heading')).toBeFocused()
  })
})

test('a file of the command line opens with its runs, and goes on where it was', async ({
  page,
}) => {
  const laboratory = new Laboratory(page)
  await laboratory.open()
  const result = await laboratory.script({ seeds: 2 })
  await page.getByTestId('lab-back').click()
  const partly = JSON.parse(result.files.json)
  partly.rows.splice(1, 1)
  const open = page.getByTestId('lab-file')
  await open.setInputFiles({
    name: 'partly.json',
    mimeType: 'application/json',
    buffer: Buffer.from(JSON.stringify(partly)),
  })
  await expect.poll(() => laboratory.phase()).toBe('paused')
  await expect.poll(() => laboratory.done()).toBe(3)
  await page.getByTestId('lab-go-on').click()
  await laboratory.finished()
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
  const laboratory = new Laboratory(page)
  await laboratory.open()
  const file = readFileSync(join(__dirname, '../../experiments/maps/ship-20x20.json'), 'utf8')
  await new Lab(page).drop('ship.json', file)
  await expect(laboratory.maps).toHaveCount(2)
  await expect(laboratory.maps.last()).toContainText('20 × 20')
})
