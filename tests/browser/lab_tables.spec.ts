import AxeBuilder from '@axe-core/playwright'
import { expect, test } from '@playwright/test'
import { ENTRIES, lengths, quantile, ResultsPage, richDocument, SEEDS } from './results_page'

const FILES = {
  csv: 'rich-results.csv',
  json: 'rich-results.json',
  'summary-csv': 'rich-results.summary.csv',
  'summary-json': 'rich-results.summary.json',
  'summary-markdown': 'rich-results.summary.md',
  markdown: 'rich-results.md',
  latex: 'rich-results.tex',
  tests: 'rich-results.tests.md',
  'tests-csv': 'rich-results.tests.csv',
  'claims-csv': 'rich-results.claims.csv',
}

test.describe('tables of results', () => {
  test('the summary has the numbers of the runs, and hides no failure', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    for (const entry of ['weak', 'limits', 'theirs']) {
      const runs = await results.rows('small', entry)
      const found = lengths(runs)
      const cell = (column: string) =>
        page.getByTestId(`summary-${entry}`).locator(`[data-column="${column}"]`)
      await expect(cell('found')).toContainText(`${found.length} of ${SEEDS}`)
      await expect(cell('best')).toHaveText(Math.min(...found).toFixed(2))
      await expect(cell('median')).toContainText(quantile(found, 0.5).toFixed(2))
      const ends = [0.25, 0.75].map((p) => quantile(found, p).toFixed(2))
      await expect(cell('median')).toContainText(ends.join(' – '))
      const mean = found.reduce((sum, value) => sum + value, 0) / found.length
      await expect(cell('mean')).toContainText(`${mean.toFixed(2)} ± `)
    }
    const failed = (await results.rows('small', 'weak')).filter(({ length }) => length === '')
    expect(failed.length).toBeGreaterThan(0)
    await expect(page.getByTestId('summary-theirs')).toContainText('Theirs (from elsewhere)')
    await expect(page.getByTestId('summary-absent')).toContainText('no formulas are published')
    await expect(page.getByTestId('results')).toContainText('counts as worse than any')
  })

  test('the best of a column is set off, and columns sort', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    const optimal = (await results.rows('small', 'exact'))[0]?.length ?? ''
    const best = page.getByTestId('summary-exact').locator('[data-column="median"]')
    await expect(best.locator('strong')).toHaveText(Number(optimal).toFixed(2))
    await expect(
      page.getByTestId('summary-weak').locator('[data-column="median"] strong'),
    ).toHaveCount(0)

    const order = () =>
      page
        .getByTestId('summary-table')
        .locator('tbody tr')
        .evaluateAll((rows) => rows.map((row) => row.getAttribute('data-testid')))
    const asked = ENTRIES.map((id) => `summary-${id}`)
    await expect.poll(order).toEqual(asked)
    const head = page.getByTestId('sort-median')
    await head.click()
    await expect(page.locator('th[aria-sort="ascending"]')).toContainText('Median')
    const medians = await Promise.all(
      ['weak', 'limits', 'exact', 'theirs'].map(async (id) => ({
        id: `summary-${id}`,
        median: quantile(lengths(await results.rows('small', id)), 0.5),
      })),
    )
    medians.sort((a, b) => a.median - b.median)
    const ranked = await order()
    expect(ranked.at(-1)).toBe('summary-absent')
    const values = ranked.slice(0, -1).map((id) => medians.find((one) => one.id === id)?.median)
    expect(values).toEqual(medians.map(({ median }) => median))
    await head.click()
    await expect(page.locator('th[aria-sort="descending"]')).toContainText('Median')
    await head.click()
    await expect.poll(order).toEqual(asked)
  })

  test('another map, another effort, another target', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    const effort = page.getByTestId('summary-limits').locator('[data-column="effort"]')
    const before = await effort.textContent()
    await results.axis('moves')
    await expect(effort).not.toHaveText(before ?? '')
    await expect(page.getByTestId('summary-table')).toContainText('ant moves and cell expansions')
    await results.told()
    const reached = page.getByTestId('summary-weak').locator('[data-column="ert"] .cell-small')
    await page.getByTestId('results-target').selectOption({ index: 0 })
    const easy = Number.parseInt((await reached.textContent()) ?? '', 10)
    await page.getByTestId('results-target').selectOption({ label: 'the optimum' })
    expect(Number.parseInt((await reached.textContent()) ?? '', 10)).toBeLessThanOrEqual(easy)
    await page.getByTestId('results-map').selectOption({ label: 'Wide' })
    const found = lengths(await results.rows('wide', 'limits'))
    await expect(page.getByTestId('summary-limits').locator('[data-column="best"]')).toHaveText(
      Math.min(...found).toFixed(2),
    )
  })

  test('tests say what they can, and what they cannot', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.tab('tests')
    const words = page.getByTestId('test-sentences')
    await expect(words).toContainText(/A\* beats Weak ants in \d+% of comparisons: a large effect/)
    const cell = page.getByTestId('test-matrix').locator('tbody tr').nth(2).locator('td').first()
    await expect(cell).toContainText('large')
    await expect(cell).toHaveClass('leaning-ahead')
    const mirrored = page
      .getByTestId('test-matrix')
      .locator('tbody tr')
      .first()
      .locator('td')
      .nth(2)
    const [ahead, behind] = await Promise.all(
      [cell, mirrored].map((one) => one.locator('.matrix-main').textContent()),
    )
    expect(Number(ahead) + Number(behind)).toBeCloseTo(1, 1)
    const wilcoxon = await page.getByTestId('test-matrix').textContent()
    await page.getByTestId('test-mann-whitney').click()
    await expect(page.getByTestId('test-matrix')).not.toHaveText(wilcoxon ?? '')
    await expect(page.getByTestId('results')).toContainText(/Friedman over 2 maps: χ² = /)
  })

  test('few runs are not tested, and one map is not ranked', async ({ page }) => {
    const results = new ResultsPage(page)
    const document = JSON.parse(richDocument(6))
    document.question.instances.pop()
    document.maps.pop()
    document.given = document.given.slice(0, 6)
    await results.show(JSON.stringify(document))
    await results.tab('tests')
    await expect(page.getByTestId('test-sentences')).toContainText(
      'Fewer than 20 runs, so there are no tests: Weak ants, Trail limits, A*, Theirs (from elsewhere)',
    )
    await expect(page.getByTestId('results')).toContainText('Ranks need at least two maps')
  })

  test('published numbers stand beside ours; one that cannot be is told', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.tab('reported')
    const small = page.getByTestId('reported-small')
    const optimum = Number((await results.rows('small', 'exact'))[0]?.length).toFixed(2)
    await expect(page.getByTestId('impossible')).toHaveText(
      `Trail limits: the published 5 is below ${optimum}, the exact optimum of our map under this rule of moving. No path here can have it: on the paper’s own map, or under another rule, one may.`,
    )
    const found = lengths(await results.rows('small', 'limits'))
    await expect(small.getByRole('img', { name: /Trail limits/ }).locator('circle')).toHaveCount(
      found.length,
    )
    await expect(small.getByRole('row', { name: /Weak ants/ })).toContainText('9 (here ')
    await expect(page.getByTestId('reported-wide')).toHaveCount(0)
    const verdicts = page.getByTestId('verdicts')
    await expect(verdicts.locator('.claim-map')).toHaveCount(2)
    await expect(verdicts).toContainText('too few runs to compare')
    await page.getByTestId('open-methodology').click()
    await expect(page.getByTestId('card-dialog')).toContainText('Hyndman and Fan')
  })

  test('nothing is reported where nothing was published', async ({ page }) => {
    const results = new ResultsPage(page)
    const document = JSON.parse(richDocument(3))
    document.question.claims = []
    for (const entry of document.question.entries) delete entry.published
    await results.show(JSON.stringify(document))
    await expect(page.getByTestId('results-tab-reported')).toHaveCount(0)
    await expect(page.getByTestId('results-tab-files')).toBeVisible()
  })

  test('files hold what the engine writes, and the comparison opens again', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.tab('files')
    for (const [kind, name] of Object.entries(FILES)) {
      const file = await results.downloaded(`file-${kind}`)
      expect(file.name).toBe(name)
      expect(file.bytes.toString('utf8'), kind).toBe(await results.file(kind))
    }
    const runs = (await results.file('csv')).trim().split('\n')
    expect(runs).toHaveLength(1 + 2 * 4 * SEEDS)
    expect(await results.file('latex')).toContain('\\toprule')
    const document = await results.file('json')
    const again = await results.comparison.script({ document })
    expect(again.runs).toBe(2 * 3 * SEEDS)
    expect((await results.file('csv')).trim().split('\n')).toEqual(runs)
  })

  test('files for people are in the language of the page, those for programs in none', async ({
    page,
  }) => {
    const results = new ResultsPage(page)
    await results.show(richDocument(3))
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN')
    await results.tab('files')
    const text = async (kind: string) =>
      (await results.downloaded(`file-${kind}`)).bytes.toString('utf8')
    for (const kind of [
      'markdown',
      'tests',
      'summary-markdown',
      'latex',
      'matrix-latex',
      'fronts-markdown',
      'fronts-latex',
    ] as const) {
      const chinese = await text(kind)
      expect(chinese, kind).toMatch(/种子/)
      expect(chinese).toBe(
        await page.evaluate((kind) => window.formicarium.resultFile(kind, 'zh-CN'), kind),
      )
      // Scripts get English whatever the page is in.
      expect(await results.file(kind)).not.toMatch(/种子/)
    }
    for (const kind of ['csv', 'summary-csv', 'json'] as const)
      expect(await text(kind)).toBe(await results.file(kind))
    await expect(page.getByTestId('file-row-latex')).toContainText('ctex')
  })

  test('times have a file of their own', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.tab('files')
    const times = await results.downloaded('file-times')
    expect(times.name).toBe('rich-results.times.csv')
    const [head, ...timed] = times.bytes.toString('utf8').trim().split('\n')
    expect(head).toBe('instance,entry,seed,seconds_to_best,seconds')
    // Imported results have no times here.
    expect(timed).toHaveLength(2 * 3 * SEEDS)
    for (const line of timed) {
      const [, , , best, all] = line.split(',')
      expect(Number(all)).toBeGreaterThanOrEqual(Number(best))
    }
  })

  test('tables can be copied', async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    const results = new ResultsPage(page)
    await results.show(richDocument(3))
    await results.tab('files')
    for (const kind of ['markdown', 'summary-markdown', 'latex', 'tests']) {
      await page.getByTestId(`copy-${kind}`).click()
      await expect
        .poll(() => page.evaluate(() => navigator.clipboard.readText()))
        .toBe(await results.file(kind))
    }
  })

  test('tabs are walked with arrows', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(richDocument(3))
    const tab = (id: string) => page.getByTestId(`results-tab-${id}`)
    await tab('summary').focus()
    await page.keyboard.press('ArrowRight')
    await expect(tab('figures')).toBeFocused()
    await expect(tab('figures')).toHaveAttribute('aria-selected', 'true')
    await page.keyboard.press('End')
    await expect(tab('files')).toBeFocused()
    await page.keyboard.press('ArrowRight')
    await expect(tab('matrix')).toBeFocused()
    await page.keyboard.press('ArrowRight')
    await expect(tab('summary')).toBeFocused()
    await page.keyboard.press('Tab')
    await expect(page.getByTestId('results-map')).toBeFocused()
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious in any tab (${scheme})`, async ({ page }) => {
      test.slow()
      await page.emulateMedia({ colorScheme: scheme })
      const results = new ResultsPage(page)
      await results.show()
      for (const id of [
        'matrix',
        'summary',
        'figures',
        'fronts',
        'tests',
        'reported',
        'files',
      ] as const) {
        await results.tab(id)
        if (id === 'figures') await expect(results.picture('ranks')).toBeVisible()
        const { violations } = await new AxeBuilder({ page })
          .include('.results')
          // Parts of a picture, which as a whole has words.
          .exclude('.figure-picture svg > g')
          .analyze()
        const told = violations.filter(
          ({ impact }) => impact === 'serious' || impact === 'critical',
        )
        expect(
          told.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join('\n')}`),
          id,
        ).toEqual([])
      }
    })
  }

  test('nothing is wider than a phone, and names stay in sight @phone', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    const name = page.getByTestId('summary-limits').locator('th')
    const table = page.locator('.result-scroll').first()
    const before = await name.boundingBox()
    await table.evaluate((one) => one.scrollTo({ left: 200 }))
    expect((await name.boundingBox())?.x).toBeCloseTo(before?.x ?? 0, 0)
    for (const id of [
      'matrix',
      'summary',
      'figures',
      'fronts',
      'tests',
      'reported',
      'files',
    ] as const) {
      await results.tab(id)
      if (id === 'figures') await expect(results.picture('ranks')).toBeVisible()
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
      expect(over, id).toBeLessThanOrEqual(0)
    }
  })
})
