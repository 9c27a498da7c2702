/** Imported results: tables and data files of IOHanalyzer beside what is run here. */
import { expect, type Page, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'

const lines = (...all: string[]) => `${all.join('\n')}\n`
/** Thirty runs, one of them without a path. */
const MINE = lines(
  'entry,seed,length',
  ...Array.from({ length: 29 }, (_, at) => `Mine,${at + 1},${41 + (at % 7) / 2}`),
  'Mine,30,',
)
const IOH = lines(
  '"function evaluation" "best-so-far f(x)"',
  '1 60',
  '40 45',
  '200 40',
  '"function evaluation" "best-so-far f(x)"',
  '1 70',
  '300 39.5',
)

async function give(page: Page, name: string, text: string): Promise<void> {
  const file = { name, mimeType: 'text/plain', buffer: Buffer.from(text) }
  await page.getByTestId('own-file').setInputFiles(file)
}

const row = (page: Page, name: string) => page.getByRole('row').filter({ hasText: name })

test('a table joins the planners, and a data file of IOHanalyzer the runs that are done', async ({
  page,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('ant-system', 'astar')
  await give(page, 'mine.csv', MINE)
  await expect(page.getByTestId('own-file-item')).toContainText('mine.csv')
  await comparison.run()
  await comparison.finished()
  await expect(row(page, 'Mine')).toContainText('29 of 30')
  await expect(row(page, 'Mine')).toContainText('41.00')

  await page.getByTestId('asked').locator('summary').click()
  await give(page, 'ioh.dat', IOH)
  await expect(row(page, 'ioh')).toContainText('2 of 2')
  await expect(row(page, 'ioh')).toContainText('39.50')
  // What was run before is still there, and nothing has to be run again.
  await expect(page.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
  await expect(row(page, 'Ant System')).toContainText('30 of 30')
  await page.getByRole('tab', { name: 'Tests' }).click()
  await expect(page.getByRole('tabpanel')).toContainText('Mine')
})

test('what cannot be read is refused by line and column, and nothing is lost', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await give(page, 'bad.csv', lines('entry,seed,length', 'X,1,far'))
  await expect(page.getByTestId('own-refused')).toContainText('Line 2')
  await expect(page.getByTestId('own-refused')).toContainText('far')
  await expect(page.getByTestId('own-file-item')).toHaveCount(0)
  await expect(comparison.start).toBeEnabled()
  await give(page, 'mine.csv', MINE)
  await expect(page.getByTestId('own-refused')).toHaveCount(0)
  await page.getByTestId('own-file-item').getByRole('button').click()
  await expect(page.getByTestId('own-file-item')).toHaveCount(0)
})

test('of several maps the one is asked for on which the runs are', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await comparison.menu('lab-add-map', 'add-map-rooms')
  await expect(comparison.maps).toHaveCount(2)
  await give(page, 'mine.csv', MINE)
  await page.getByTestId('own-map').getByTestId('own-map-choice').selectOption({ index: 1 })
  await page.getByTestId('own-join').click()
  await expect(page.getByTestId('own-file-item')).toContainText('mine.csv')
  await comparison.seeds(2)
  await comparison.run()
  await comparison.finished()
  await page.getByTestId('results-map').selectOption({ index: 1 })
  await expect(row(page, 'Mine')).toContainText('29 of 30')
})
