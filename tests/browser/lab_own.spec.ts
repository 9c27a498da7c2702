/** Imported results: tables and data files of IOHanalyzer beside what is run here. */
import { expect, type Page, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { RacePage } from './race_page'

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
  await page.getByTestId('results-tab-summary').click()
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
  await expect(page.getByTestId('own-file-item')).toContainText('mine.csv')
  await expect(page.getByTestId('own-refused')).toContainText('bad.csv')
  await page.getByTestId('own-dismiss').click()
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
  await page.getByTestId('results-tab-summary').click()
  await page.getByTestId('results-map').selectOption({ index: 1 })
  await expect(row(page, 'Mine')).toContainText('29 of 30')
})

test('results that are dropped on the race join a form that was never on show', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.open()
  await race.drop('ioh_new.dat', IOH)
  await new ComparisonPage(page).ready()
  const item = page.getByTestId('own-file-item')
  await expect(item).toContainText('ioh_new.dat')
  await expect(item).toContainText('2 runs read, 2 with a path.')
  await expect(page.getByTestId('draft-map')).toHaveCount(1)
})

test('it is told what was read, on which maps, and what was left out', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await comparison.on('rooms', 'maze')
  const table = lines(
    'entry,map,seed,length,mood',
    'Mine,Rooms,1,60,good',
    'Mine,corridor,1,12,bad',
    'Mine,corridor,2,13,bad',
    'Yours,Maze,1,,bad',
  )
  await give(page, 'mine.csv', table)
  const refused = page.getByTestId('own-refused')
  await expect(refused).toContainText('2 runs are on “corridor”')
  await expect(page.getByTestId('own-file-item')).toHaveCount(0)
  await page.getByTestId('own-leave-out').click()
  const item = page.getByTestId('own-file-item')
  for (const told of [
    '4 runs read, 3 with a path',
    '2 entries: Mine, Yours.',
    '2 maps: Rooms',
    'Left out: 2 runs on “corridor”',
    'mood',
  ])
    await expect(item).toContainText(told)
  await comparison.seeds(1)
  await comparison.run()
  await comparison.finished()
  await page.getByTestId('results-tab-summary').click()
  await page.getByTestId('results-map').selectOption({ index: 0 })
  await expect(row(page, 'Mine')).toContainText('1 of 1')
})

test('a file of one unknown map is asked about, and can be dropped again', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await give(page, 'mine.csv', lines('map,length', 'corridor,41'))
  await expect(page.getByTestId('own-map')).toContainText('corridor')
  await page.getByTestId('own-dismiss').click()
  await expect(page.getByTestId('own-map')).toHaveCount(0)
  await give(page, 'mine.csv', lines('map,length', 'corridor,41'))
  await page.getByTestId('own-join').click()
  await expect(page.getByTestId('own-file-item')).toContainText('1 run read, 1 with a path.')
})

test('every file keeps its question until it is answered, and the line names the map', async ({
  page,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await comparison.on('rooms', 'maze')
  await give(page, 'first.csv', lines('entry,map,length', 'Mine,corridor,41'))
  await give(page, 'second.csv', lines('entry,map,length', 'Yours,hall,42'))
  const questions = page.getByTestId('own-map')
  await expect(questions).toHaveCount(2)
  await expect(page.getByTestId('not-joined')).toContainText('2 files of results')
  await expect(comparison.start).toBeEnabled()
  await questions.first().getByTestId('own-map-choice').selectOption({ label: 'Rooms' })
  await questions.first().getByTestId('own-join').click()
  await expect(page.getByTestId('own-file-item')).toContainText('corridor → Rooms')
  await expect(questions).toHaveCount(1)
  await expect(questions).toContainText('hall')
  await expect(page.getByTestId('not-joined')).toContainText('1 file of results')
  await questions.getByTestId('own-dismiss').click()
  await expect(page.getByTestId('not-joined')).toHaveCount(0)
})

test('results that come while runs go on pause them, and say so', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('ant-system')
  await comparison.seeds(2000)
  await comparison.run()
  await expect(page.getByTestId('lab')).toHaveAttribute('data-phase', 'running')
  await new RacePage(page).drop('mine.csv', MINE)
  await expect(page.getByTestId('toast-info')).toContainText('paused to join mine.csv')
  await expect(page.getByTestId('toast-success')).toContainText('mine.csv joined')
})

test('an empty table is there to be filled in, and says so when it comes back empty', async ({
  page,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await comparison.seeds(2)
  const waiting = page.waitForEvent('download')
  await page.getByTestId('own-template').click()
  const saved = await waiting
  expect(saved.suggestedFilename()).toBe('results.csv')
  const chunks: Buffer[] = []
  for await (const chunk of await saved.createReadStream()) chunks.push(Buffer.from(chunk))
  const text = Buffer.concat(chunks).toString()
  const [header, ...rows] = text.trimEnd().split('\n')
  expect(header).toBe('entry,instance,seed,length,turns,evaluations')
  expect(rows).toHaveLength(2)
  await give(page, saved.suggestedFilename(), text)
  await expect(page.getByTestId('own-file-item')).toContainText('No run of the file has a path')
  await give(page, 'mine.csv', text.replaceAll(',,,', ',41,,'))
  await expect(page.getByTestId('own-file-item').nth(1)).toContainText('2 with a path')
})
