import { expect, type Locator, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'
import { ResultsPage, richDocument } from './results_page'

const FIGURES = ['values', 'convergence', 'targets', 'effort', 'gaps', 'ranks'] as const

/** Names that no phone is wide enough for, and runs without a path. */
function longNamed(): string {
  const document = JSON.parse(richDocument())
  for (const entry of document.question.entries)
    entry.label += ', with all that has to be said about it in a table and in a legend'
  return JSON.stringify(document)
}

/** Pairs of words that lie on each other, and words that are cut off at the edges. */
const faults = (svg: Locator) =>
  svg.evaluate((root: SVGSVGElement) => {
    const width = root.viewBox.baseVal.width
    const words = [...root.querySelectorAll('text')].flatMap((text) => {
      const { x, y, width, height } = text.getBBox()
      const at = text.getCTM()
      const origin = root.getCTM()
      if (!at || !origin || !text.textContent) return []
      const [left, top] = [x + at.e - origin.e, y + at.f - origin.f]
      // A line's height has air above and below its letters.
      return [
        {
          says: text.textContent,
          left,
          right: left + width,
          top: top + 0.15 * height,
          bottom: top + 0.85 * height,
        },
      ]
    })
    const cut = words.filter(({ left, right }) => left < -1 || right > width + 1)
    const touching = words.flatMap((a, i) =>
      words
        .slice(i + 1)
        .filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        .map((b) => `${a.says} | ${b.says}`),
    )
    return [...cut.map(({ says }) => says), ...touching]
  })

for (const where of ['desktop', 'phone @phone']) {
  test(`no words lie on others or are cut off in figures (${where})`, async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(longNamed())
    await results.figures()
    await expect(results.picture('ranks')).toBeVisible()
    for (const id of FIGURES) expect(await faults(results.picture(id)), id).toEqual([])
  })
}

test('an effect has a name only where the test is sure', async ({ page }) => {
  const document = JSON.parse(richDocument())
  // The same planner twice: nothing is there to be shown.
  document.question.entries[2] = { ...document.question.entries[1], id: 'again', label: 'Again' }
  document.question.claims = []
  const results = new ResultsPage(page)
  await results.show(JSON.stringify(document))
  await results.tab('tests')
  await page.getByTestId('test-mann-whitney').click()
  const cells = page.getByTestId('test-matrix').locator('tbody td:not(.diagonal)')
  const told = await cells.evaluateAll((all) =>
    all.map((cell) => {
      const [a = '', effect = '', p = ''] = [...cell.children].map((one) => one.textContent ?? '')
      return { a: Number(a), effect, p: Number(p.replace(/^p [=<] /, '')), sure: p.includes('<') }
    }),
  )
  expect(told.length).toBeGreaterThan(0)
  for (const { a, effect, p, sure } of told) {
    expect(a).not.toBeNaN()
    if (sure || p < 0.05) expect(effect).toMatch(/negligible|small|medium|large/)
    else expect(effect).toBe('cannot tell')
  }
  expect(told.filter(({ effect }) => effect === 'cannot tell').length).toBeGreaterThan(0)
})

test('several published numbers that cannot be are told in one box', async ({ page }) => {
  const document = JSON.parse(richDocument(3))
  document.question.entries[0].published.small = { length: 4.5 }
  document.question.claims = []
  const results = new ResultsPage(page)
  await results.show(JSON.stringify(document))
  await results.tab('reported')
  const optimum = Number((await results.rows('small', 'exact'))[0]?.length).toFixed(2)
  const box = page.getByTestId('impossible')
  await expect(box).toHaveCount(1)
  await expect(box).toContainText(
    'below the exact optimum of our map under our reading of the rule',
  )
  await expect(box.getByRole('listitem')).toHaveText([
    `Weak ants: 4.5 < ${optimum}`,
    `Trail limits: 5 < ${optimum}`,
  ])
})

test('what is in an ablation is not taken apart again', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('ship')
  await comparison.entry(1).getByTestId('ablate').click()
  await expect.poll(() => comparison.entries.count()).toBeGreaterThan(1)
  await expect(page.getByTestId('ablate')).toHaveCount(0)
  await comparison.add('ship')
  await expect(page.getByTestId('ablate')).toHaveCount(1)
  // Alone it is a planner like any other.
  for (let left = await comparison.entries.count(); left > 1; left--)
    await comparison.entry(left).getByTestId('entry-remove').click()
  await expect(comparison.entry(1).getByTestId('ablate')).toBeVisible()
})
