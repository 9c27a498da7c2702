import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { ResultsPage, richDocument, SEEDS } from './results_page'

type Line = Record<string, string>

function linesOf(csv: string): Line[] {
  const [head, ...rows] = csv.trim().split('\n')
  const names = head?.split(',') ?? []
  return rows.map((row) => {
    const fields = row.split(',')
    return Object.fromEntries(names.map((name, at) => [name, fields[at] ?? '']))
  })
}

/** The document with one run from elsewhere that is shorter than any path. */
function withImpossible(): string {
  const document = JSON.parse(richDocument())
  const first = document.given[0].found
  first.length = 3
  first.value = 3
  return JSON.stringify(document)
}

const field = (page: Page, map: string, place: number) =>
  page.getByTestId(`matrix-${map}`).locator('td').nth(place)

test.describe('the overview of a comparison', () => {
  test('is what results open on, with the numbers of the result file', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.comparison.open()
    await results.comparison.script({ document: richDocument() })
    await results.comparison.finished()
    const table = page.getByTestId('matrix-table')
    await expect(table).toBeVisible()
    const lines = linesOf(await results.file('matrix-csv'))
    const columns = ['weak', 'limits', 'exact', 'theirs', 'absent']
    for (const { instance, entry, median, rank, gap } of lines.filter((line) => line.instance)) {
      const cell = field(page, instance ?? '', columns.indexOf(entry ?? ''))
      if (median === '') await expect(cell).toHaveText('not run')
      else {
        await expect(cell.locator('.matrix-large')).toHaveText(Number(median).toFixed(2))
        await expect(cell.locator('[data-part="rank"]')).toHaveCount(rank === '' ? 0 : 1)
        await expect(cell.locator('[data-part="gap"]')).toContainText(
          (100 * Number(gap)).toFixed(1).replace(/\.0$/, ''),
        )
      }
    }
    await page.getByTestId('matrix-rank').click()
    const { rank } = lines.find((line) => !line.instance && line.entry === 'exact') ?? {}
    await expect(page.getByTestId('matrix-overall').locator('.matrix-large').nth(2)).toHaveText(
      String(Number(rank)),
    )
    await page.getByTestId('matrix-median').click()
    // A map of it leads to all numbers of that map.
    await page.getByTestId('matrix-map-wide').click()
    await expect(page.getByTestId('summary-table')).toBeVisible()
    await expect(page.getByTestId('results-map')).toHaveValue('wide')
  })

  test('with one map has one row', async ({ page }) => {
    const document = JSON.parse(richDocument(3))
    document.question.instances.pop()
    document.maps.pop()
    document.given = document.given.slice(0, 3)
    const results = new ResultsPage(page)
    await results.show(JSON.stringify(document))
    await results.tab('matrix')
    await expect(page.getByTestId('matrix-table').locator('tbody tr')).toHaveCount(1)
    await expect(field(page, 'small', 2).locator('[data-part="rank"]')).toHaveText(/rank 1/)
    await expect(page.getByTestId('matrix-overall')).toHaveCount(0)
  })

  test('ranks, tests and prefers nothing that is impossible', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(withImpossible())
    const theirs = page.getByTestId('summary-theirs')
    await expect(theirs).toContainText('Theirs (from elsewhere) †')
    await expect(theirs.locator('strong')).toHaveCount(0)
    await expect(page.getByTestId('impossible')).toContainText('Theirs (from elsewhere) †: 1 run')
    await results.tab('matrix')
    await expect(page.getByTestId('matrix-head-theirs')).toContainText('(from elsewhere) †')
    await expect(field(page, 'small', 3)).toContainText(`1 of ${SEEDS} runs impossible`)
    await expect(field(page, 'small', 3).locator('[data-part="rank"]')).toHaveCount(0)
    await expect(page.getByTestId('matrix-overall').locator('td').nth(3)).toContainText(
      'not ranked: impossible runs',
    )
    await expect(page.getByTestId('matrix-notes')).toContainText('better than the proven optimum')
    await results.tab('tests')
    await expect(page.getByTestId('test-sentences')).toContainText('In no test')
    await results.figures()
    await expect(results.picture('values')).toContainText('better than the proven optimum')
    for (const file of ['latex', 'matrix-latex', 'summary-markdown', 'matrix-markdown']) {
      const text = await results.file(file)
      expect(text, file).toContain('(from elsewhere)')
      expect(text, file).toContain('impossible on this map')
    }
    const bold = (await results.file('summary-markdown'))
      .split('\n')
      .filter((line) => line.includes('Theirs') && line.includes('**'))
    // On the other map nothing of theirs is impossible.
    expect(bold.filter((line) => line.includes('†'))).toEqual([])
  })

  test('says why there is no expected effort', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    const why = (entry: string) =>
      page.getByTestId(`summary-${entry}`).locator('[data-column="ert"] .cell-small')
    await expect(why('theirs')).toHaveText(/effort not told|no run reaches it/)
    await results.axis('iterations')
    await expect(why('exact')).toHaveText('has no iterations')
    await expect(page.getByTestId('summary-exact').locator('[data-column="effort"]')).toHaveText(
      '–',
    )
  })

  test('counts runs that need no seeds alike everywhere', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(richDocument(4))
    await expect(results.comparison.runWords).toContainText('All 24 runs are done')
    await expect(results.comparison.runWords).toContainText('8 of them need no seeds')
    await expect(results.comparison.runWords).toContainText('8 runs from elsewhere')
    for (const file of ['latex', 'markdown'])
      expect(await results.file(file)).toContain(
        '24 runs, 8 of them by searches that need no seeds, alike on each map, beside 8 runs from elsewhere',
      )
  })

  for (const scheme of ['light', 'dark'] as const)
    test(`axe finds nothing in it (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      const results = new ResultsPage(page)
      await results.show(withImpossible())
      await results.tab('matrix')
      const { violations } = await new AxeBuilder({ page }).include('.results').analyze()
      expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([])
    })
})

test.describe('a press right after typing', () => {
  for (const typed of ['5', '40']) {
    test(`starts the runs with ${typed} seeds`, async ({ page }) => {
      const comparison = new ComparisonPage(page)
      await comparison.open()
      await comparison.on('open-field')
      await comparison.compare('astar')
      const count = page.getByTestId('seed-count')
      await count.fill(typed === '5' ? '30' : '3')
      await count.press('Enter')
      await count.click()
      await page.keyboard.press('ControlOrMeta+a')
      await page.keyboard.type(typed)
      const before = await centre(page)
      await page.mouse.move(before.x, before.y)
      await page.mouse.down()
      const after = await centre(page)
      expect(after.y).toBe(before.y)
      await page.mouse.up()
      await comparison.finished()
      expect(await comparison.words()).toContain(`${typed} runs are done`)
    })
  }

  test('counts where something moves the button away', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.on('open-field')
    await comparison.compare('astar')
    await comparison.seeds(2)
    // Whatever makes the page longer while the pointer is down.
    await comparison.start.evaluate((button) =>
      button.addEventListener('pointerdown', () => {
        const more = document.createElement('div')
        more.style.height = '60px'
        document.querySelector('.start-bar')?.before(more)
      }),
    )
    const { x, y } = await centre(page)
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.up()
    await comparison.finished()
  })

  test('is taken back where the pointer is drawn off the button', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { x, y } = await centre(page)
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x, y - 200)
    await page.mouse.up()
    expect(await comparison.phase()).toBe('idle')
  })
})

async function centre(page: Page): Promise<{ x: number; y: number }> {
  const button = page.getByTestId('lab-start')
  await button.scrollIntoViewIfNeeded()
  const box = await button.boundingBox()
  if (!box) throw new Error('the button is not to be seen')
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

test('a terrain has a picture in the builder', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.on('terrain-hills')
  const colours = await comparison.maps.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
    const { width, height } = canvas
    const { data } = canvas.getContext('2d')?.getImageData(0, 0, width, height) ?? { data: [] }
    const seen = new Set<number>()
    for (let at = 0; at < data.length; at += 4)
      seen.add((data[at] ?? 0) * 256 + (data[at + 1] ?? 0))
    return seen.size
  })
  expect(colours).toBeGreaterThan(50)
})

for (const [width, height] of [
  [2560, 1300],
  [320, 700],
] as const)
  test(`the results fit ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height })
    const results = new ResultsPage(page)
    const over = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    await results.comparison.open()
    expect(await over()).toBeLessThanOrEqual(0)
    await results.show()
    for (const id of ['matrix', 'summary', 'figures', 'tests', 'reported', 'files'] as const) {
      await results.tab(id)
      if (id === 'figures') await expect(results.picture('ranks')).toBeVisible()
      expect(await over(), id).toBeLessThanOrEqual(0)
    }
    const box = await page.getByTestId('results').boundingBox()
    expect(box?.width).toBeGreaterThan(0.9 * width)
  })

test('the files of the overview are saved under the names of the command line', async ({
  page,
}) => {
  const results = new ResultsPage(page)
  await results.show(richDocument(2))
  await results.tab('files')
  for (const [kind, ending] of [
    ['matrix-csv', 'matrix.csv'],
    ['matrix-markdown', 'matrix.md'],
    ['matrix-latex', 'matrix.tex'],
  ] as const) {
    const file = await results.downloaded(`file-${kind}`)
    expect(file.name).toBe(`rich-results.${ending}`)
    expect(file.bytes.toString('utf8')).toBe(await results.file(kind))
  }
})
