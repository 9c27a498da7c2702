import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import { expect, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { RacePage } from './race_page'

const records = join(__dirname, '../../experiments/records')

/** The head of a record, and the lines of its first seeds, in the order of the runs. */
function recorded(name: string, seeds: number): string[] {
  const [head = '', ...lines] = readFileSync(join(records, `${name}.csv`), 'utf8')
    .trim()
    .split('\n')
  return [head, ...lines.filter((line) => Number(line.split(',')[2]) <= seeds)]
}

test.describe('the papers’ questions', () => {
  test('are listed with what they ask and how long it takes', async ({ page }) => {
    await new ComparisonPage(page).open()
    const list = page.getByTestId('published')
    await expect(list.locator('li')).toHaveCount(8)
    const ship = page.getByTestId('published-ship')
    await expect(ship).toContainText('Engine-room ACO against the basic ACO')
    await expect(ship).toContainText('33 maps · 15 entries · 13,860 runs · about')
    await page.getByTestId('published-seeds-ship').fill('100')
    await expect(ship).toContainText('46,200 runs')
    await page.getByTestId('published-seeds-ship').fill('2')
    await expect(ship).toContainText('924 runs')
    await expect(ship).toContainText('Claims are judged from 30 seeds on.')
    const { violations } = await new AxeBuilder({ page }).include('.published').analyze()
    expect(violations).toEqual([])
    await page.getByTestId('published-card-ship').click()
    await expect(page.getByTestId('card-dialog')).toContainText('engine', { ignoreCase: true })
  })

  for (const [name, seeds] of [
    ['threshold', 2],
    ['fire', 1],
    ['classics', 1],
  ] as const) {
    test(`${name}: what runs here is what is recorded, line by line`, async ({ page }) => {
      const comparison = new ComparisonPage(page)
      await comparison.open()
      await page.getByTestId(`published-seeds-${name}`).fill(String(seeds))
      await page.getByTestId(`published-run-${name}`).click()
      await comparison.finished(110_000)
      const csv = await page.evaluate(() => window.formicarium.resultFile('csv'))
      expect(csv.trim().split('\n')).toEqual(recorded(name, seeds))
      await page.getByRole('tab', { name: /report/i }).click()
      await expect(page.getByTestId('verdicts')).toBeVisible()
    })
  }

  test('what a reader of the verdicts must know stands below them', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await page.getByTestId('published-seeds-ship').fill('1')
    await page.getByTestId('published-run-ship').click()
    await comparison.finished(110_000)
    await page.getByRole('tab', { name: /report/i }).click()
    const notes = page.getByTestId('reservations').getByRole('listitem')
    await expect(notes).toHaveText([
      /^shorter paths, fewer turns\s*The refined path may take any angle/,
      /^fewer iterations\s*Not independent: μ, ω, γ and k are not given/,
    ])
  })

  test('a map that stands for a paper’s leads to its question', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await race.menu('map-menu', 'gallery-paper-ship-30')
    await page.getByRole('button', { name: 'Reported and reproduced…' }).click()
    const first = page.getByTestId('published').locator('li').first()
    await expect(first).toHaveAttribute('data-testid', 'published-ship')
    await expect(first).toContainText('about the map of “Watch”')
    await expect(first).toBeInViewport()
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(first).toContainText('机舱蚁群算法')
  })
})
