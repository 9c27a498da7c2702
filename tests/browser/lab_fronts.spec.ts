import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { ResultsPage, richDocument } from './results_page'

type Line = Record<string, string>

function linesOf(csv: string): Line[] {
  const [head, ...rows] = csv.trim().split('\n')
  const names = head?.split(',') ?? []
  return rows.map((row) => {
    const fields = row.split(',')
    return Object.fromEntries(names.map((name, at) => [name, fields[at] ?? '']))
  })
}

async function shown(page: Page, document = richDocument()): Promise<ResultsPage> {
  const results = new ResultsPage(page)
  await results.show(document)
  await results.tab('fronts')
  await expect(results.picture('fronts')).toBeVisible()
  return results
}

const row = (page: Page, entry: string) => page.getByTestId(`fronts-row-${entry}`)

test.describe('what the runs of a comparison trade off', () => {
  test('stands in a table and a picture, by the numbers of the result file', async ({ page }) => {
    const results = await shown(page)
    const lines = linesOf(await results.file('fronts-csv')).filter(
      (line) => line.instance === 'small',
    )
    for (const entry of ['weak', 'limits', 'exact']) {
      const first = lines.find((line) => line.entry === entry)
      const cells = row(page, entry).locator('td')
      await expect(cells.nth(0)).toHaveText(Number(first?.hypervolume).toFixed(4))
      await expect(cells.nth(2)).toHaveText(first?.joint ?? '')
      await expect(cells.nth(4)).toHaveText(first?.own ?? '')
    }
    // Results from elsewhere tell no turns: they are no points.
    await expect(row(page, 'theirs').locator('td').first()).toHaveText('–')
    const points = lines.filter((line) => line.on_own === 'true')
    await expect(results.picture('fronts').locator('.front-points *:is(path, circle)')).toHaveCount(
      points.length,
    )
    await expect(results.picture('fronts').locator('.front path')).toHaveCount(3)
    await expect(page.getByTestId('fronts-about')).toContainText('less is better')
    expect(await results.picture('fronts').getAttribute('aria-label')).toContain('hypervolume')
  })

  test('is asked over other measures, and against another reference point', async ({ page }) => {
    const results = await shown(page)
    await page.getByTestId('fronts-second').selectOption('mean-clearance')
    await expect(page.getByTestId('fronts-about')).toContainText('more is better')
    // Choosing what is chosen already exchanges the two.
    await page.getByTestId('fronts-first').selectOption('mean-clearance')
    await expect(page.getByTestId('fronts-second')).toHaveValue('length')
    await page.getByTestId('fronts-third').selectOption('turns')
    await expect(results.picture('fronts').locator('.front')).toHaveCount(0)
    await page.getByTestId('fronts-third').selectOption('none')
    await expect(results.picture('fronts').locator('.front')).not.toHaveCount(0)
    await page.getByTestId('fronts-own-reference').check()
    await page.getByTestId('fronts-reference-1').fill('400')
    await page.getByTestId('fronts-reference-1').press('Enter')
    await expect(page.getByTestId('fronts-about')).toContainText('path length (cells): 400')
    // The files of the tab are over what it shows.
    await results.tab('files')
    const csv = (await results.downloaded('file-fronts-csv')).bytes.toString('utf8')
    const [line] = linesOf(csv)
    expect([line?.first_measure, line?.second_measure, line?.second_reference]).toEqual([
      'mean-clearance',
      'length',
      '400.0',
    ])
    const markdown = (await results.downloaded('file-fronts-markdown')).bytes.toString('utf8')
    expect(markdown).toContain('Mean clearance (more is better), length (less is better)')
  })

  test('can be taken away as a table and as files', async ({ page }) => {
    const results = await shown(page)
    await page.getByTestId('figure-fronts-table').click()
    const own = linesOf(await results.file('fronts-csv')).filter(
      (line) => line.instance === 'small' && line.on_own === 'true',
    )
    await expect(results.figure('fronts').locator('tbody tr')).toHaveCount(own.length)
    const svg = await results.downloaded('figure-fronts-svg')
    expect(svg.name).toBe('rich-results-fronts-small.svg')
    expect(svg.bytes.toString('utf8')).toContain('reference point')
    const png = await results.downloaded('figure-fronts-png')
    expect(png.bytes.subarray(1, 4).toString()).toBe('PNG')
  })

  test('is in Chinese where the page is', async ({ page }) => {
    await shown(page, richDocument(3))
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(page.getByTestId('results-tab-fronts')).toHaveText('权衡')
    await expect(page.getByTestId('fronts-about')).toContainText('越小越好')
    await expect(page.getByTestId('fronts-about')).not.toContainText(/[a-z]{3}/)
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      await shown(page, richDocument(3))
      await expectClean(page, scheme)
    })
  }

  test('is no wider than a phone @phone', async ({ page }) => {
    await shown(page, richDocument(3))
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    expect(over).toBeLessThanOrEqual(0)
  })
})
