import { expect, type Page, test } from '@playwright/test'
import { lengths, ResultsPage, richDocument, SEEDS } from './results_page'

/** Every figure that shows effort, and all that show none. */
const WITH_EFFORT = ['convergence', 'targets', 'effort']
const WITHOUT = ['values', 'gaps', 'ranks']

const AXES = {
  iterations: 'iterations',
  'constructed-paths': 'constructed paths',
  moves: 'ant moves and cell expansions',
  time: 'seconds',
} as const

/** What must stand at the axis of each. */
const LABELS = [
  ['values', 'path length (cells)'],
  ['convergence', 'constructed paths'],
  ['targets', 'solved (run, target) pairs'],
  ['effort', 'constructed paths'],
  ['gaps', 'gap to the exact optimum'],
  ['ranks', 'mean rank (1 = best)'],
] as const

interface Svg {
  wellFormed: boolean
  width: number
  height: number
  texts: string[]
  /** By class of their group: how many shapes there are. */
  shapes: Record<string, number>
  outside: string[]
  background: string | null
}

/** What a file holds, by the browser's own parser. */
function parsed(page: Page, text: string): Promise<Svg> {
  return page.evaluate((source) => {
    const root = new DOMParser().parseFromString(source, 'image/svg+xml').documentElement
    const groups = [...root.querySelectorAll('g[class]')]
    const shapes: Record<string, number> = {}
    for (const group of groups) {
      const name = group.getAttribute('class') ?? ''
      shapes[name] =
        (shapes[name] ?? 0) + group.querySelectorAll('path, circle, rect, line, text').length
    }
    return {
      wellFormed: root.nodeName === 'svg' && root.querySelector('parsererror') === null,
      width: Number(root.getAttribute('width')),
      height: Number(root.getAttribute('height')),
      texts: [...root.querySelectorAll('text')].map((one) => one.textContent ?? ''),
      shapes,
      outside:
        source.match(/currentColor|var\(--[\w-]+\)|href="http[^"]*"|url\((?!#|data:)[^)]*\)/g) ??
        [],
      background: root.querySelector('rect')?.getAttribute('fill') ?? null,
    }
  }, text)
}

/** Clips have a new number in every drawing. */
const drawn = (results: ResultsPage, id: string) =>
  results.picture(id).evaluate((svg) => svg.innerHTML.replace(/plot-clip-\d+/g, 'clip'))

test.describe('figures of results', () => {
  test('a point for every run with a path, and a word for every other', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.figures()
    const entries = ['weak', 'limits', 'exact', 'theirs']
    const runs = await Promise.all(entries.map((id) => results.rows('small', id)))
    const found = runs.map((rows) => lengths(rows).length)
    const all = found.reduce((sum, count) => sum + count, 0)
    await expect(results.picture('values').locator('.runs path')).toHaveCount(all)
    await expect(results.picture('values').locator('.boxes rect')).toHaveCount(4)
    await expect(results.picture('values').locator('.published path')).toHaveCount(2)
    await expect(results.picture('values')).toContainText(
      `${SEEDS - (found[0] ?? 0)} of ${SEEDS} found no path`,
    )
    const optimum = Number(runs[2]?.[0]?.length).toFixed(2)
    await expect(results.picture('values')).toContainText(`exact optimum ${optimum}`)
    // Bars of gaps count the same runs.
    const counted = async () => {
      const counts = await results.picture('gaps').locator('.counts text').allTextContents()
      return counts.reduce((sum, text) => sum + Number(text), 0)
    }
    await expect.poll(counted).toBe(4 * SEEDS)
    // Imported results come without effort.
    await expect(results.picture('convergence')).toContainText(
      'Effort not known: Theirs (from elsewhere).',
    )
    await expect(results.picture('convergence').locator('.curves path')).toHaveCount(3)
  })

  test('one press changes the effort of every figure that shows one', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.figures()
    const seen = new Map<string, Set<string>>(WITH_EFFORT.map((id) => [id, new Set()]))
    const others = await Promise.all(WITHOUT.map((id) => drawn(results, id)))
    for (const [axis, words] of Object.entries(AXES)) {
      await results.axis(axis as keyof typeof AXES)
      for (const id of WITH_EFFORT) {
        await expect(
          results.picture(id).locator('text').filter({ hasText: words }),
        ).not.toHaveCount(0)
        seen.get(id)?.add(await drawn(results, id))
      }
    }
    for (const id of WITH_EFFORT) expect(seen.get(id)?.size, id).toBe(4)
    expect(await Promise.all(WITHOUT.map((id) => drawn(results, id)))).toEqual(others)
    await expect(results.picture('targets')).toContainText('not part of result files')
  })

  test('linear and logarithmic effort', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.figures()
    const before = await drawn(results, 'convergence')
    await page.getByTestId('figures-log').uncheck()
    await expect.poll(() => drawn(results, 'convergence')).not.toBe(before)
    await page.getByTestId('figures-log').check()
    await expect.poll(() => drawn(results, 'convergence')).toBe(before)
  })

  for (const [ground, fill] of [
    ['light', '#ffffff'],
    ['dark', '#141c1a'],
  ] as const) {
    test(`an SVG stands alone (${ground})`, async ({ page }) => {
      const results = new ResultsPage(page)
      await results.show()
      await results.figures()
      const found = await results.picture('values').locator('.runs path').count()
      await page.getByTestId(`ground-${ground}`).click()
      for (const [id, label] of LABELS) {
        const { name, bytes } = await results.downloaded(`figure-${id}-svg`)
        const about = id === 'ranks' ? '' : '-small'
        expect(name).toBe(`rich-results-${id}${about}.svg`)
        const svg = await parsed(page, bytes.toString('utf8'))
        expect(svg, id).toMatchObject({ wellFormed: true, outside: [], background: fill })
        expect(svg.texts).toContain(label)
        const of = id === 'ranks' ? '2 maps' : 'Small'
        expect(svg.texts.join(' ')).toContain(`Rich results · ${of}`)
        if (id === 'values') expect(svg.shapes.runs).toBe(found)
      }
    })
  }

  test('names hold what XML does not allow, and an SVG is well-formed all the same', async ({
    page,
  }) => {
    const name = 'a\u0000b\u0008c\u000bd\u001fe\ufffef\uffff <&"\'> 蚁🐜'
    const document = JSON.parse(richDocument())
    document.question.entries[0].label = name
    document.question.title = `Rich ${name}`
    const results = new ResultsPage(page)
    await results.show(JSON.stringify(document))
    await results.figures()
    const { bytes } = await results.downloaded('figure-ranks-svg')
    const svg = await parsed(page, bytes.toString('utf8'))
    expect(svg.wellFormed).toBe(true)
    expect(svg.texts.join(' ')).toContain('a\ufffdb\ufffdc\ufffdd\ufffde\ufffdf\ufffd <&"\'> 蚁🐜')
    await results.downloaded('figure-ranks-png')
  })

  test('a PNG has twice the pixels of the SVG', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.figures()
    const svg = await parsed(
      page,
      (await results.downloaded('figure-values-svg')).bytes.toString('utf8'),
    )
    const { name, bytes } = await results.downloaded('figure-values-png')
    expect(name).toBe('rich-results-values-small.png')
    expect(bytes.subarray(1, 4).toString('latin1')).toBe('PNG')
    // IHDR is the first chunk: width and height stand at 16 and 20.
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([
      2 * svg.width,
      2 * svg.height,
    ])
    const colours = await page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))
      const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
      const canvas = new OffscreenCanvas(picture.width, picture.height)
      const context = canvas.getContext('2d')
      context?.drawImage(picture, 0, 0)
      const { data: pixels = [] } = context?.getImageData(0, 0, picture.width, picture.height) ?? {}
      const seen = new Set<number>()
      for (let i = 0; i < pixels.length; i += 4)
        seen.add(((pixels[i] ?? 0) << 16) | ((pixels[i + 1] ?? 0) << 8) | (pixels[i + 2] ?? 0))
      return [...seen]
    }, bytes.toString('base64'))
    // White ground, ink, and the first series.
    for (const colour of [0xffffff, 0x14211d, 0xd5580a]) expect(colours).toContain(colour)
  })

  test('the same numbers as a table, and words for who cannot see', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show()
    await results.figures()
    for (const id of [...WITH_EFFORT, ...WITHOUT]) {
      await expect(results.picture(id)).toHaveAttribute('role', 'img')
      await expect(results.picture(id)).toHaveAttribute('aria-label', /A\*/)
      await page.getByTestId(`figure-${id}-table`).click()
      await expect(results.figure(id).getByRole('table')).toContainText('A*')
      await expect(results.picture(id)).toHaveCount(0)
    }
    const median = page.getByTestId('figure-values').getByRole('row', { name: /Trail limits/ })
    const text = await median.textContent()
    await results.tab('summary')
    const best = page.getByTestId('summary-limits').locator('[data-column="best"]')
    expect(text).toContain((await best.textContent()) ?? '?')
  })

  test('figures follow theme, language and width', async ({ page }) => {
    const results = new ResultsPage(page)
    await results.show(richDocument(4))
    await results.figures()
    const light = await drawn(results, 'values')
    await page.getByTestId('theme').click()
    await page.getByTestId('theme-dark').click()
    await expect.poll(() => drawn(results, 'values')).not.toBe(light)
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(results.picture('values')).toContainText('路径长度（格）')
    // Where lines may break anywhere, spaces beside numbers stay.
    await expect(results.picture('values')).toContainText('距箱体 1.5 倍四分位距')
    const wide = await results.picture('values').getAttribute('width')
    await page.setViewportSize({ width: 800, height: 900 })
    await expect(results.picture('values')).not.toHaveAttribute('width', wide ?? '')
    const inside = () =>
      results
        .figure('values')
        .evaluate(
          (card) =>
            (card.querySelector('svg[role]')?.getBoundingClientRect().width ?? Infinity) <=
            card.clientWidth,
        )
    await expect.poll(inside).toBe(true)
  })

  test('an ablation shows what each component does', async ({ page }) => {
    const document = JSON.parse(richDocument(20))
    const set = { iterations: 8, ants: 4 }
    document.question.claims = []
    document.question.entries = [
      { id: 'full', label: 'All of it', role: 'improved', planner: 'rank-based-ant-system', set },
      ...['ranking', 'best-so-far-deposit'].map((id) => ({
        id: `without-${id}`,
        label: `Without ${id}`,
        role: 'other',
        planner: 'rank-based-ant-system',
        set: { ...set, ...(id === 'ranking' ? { ranking: false } : { best_so_far: false }) },
      })),
    ]
    document.given = []
    const results = new ResultsPage(page)
    await results.show(JSON.stringify(document))
    await results.figures()
    await expect(results.picture('ablation').locator('.effects path')).toHaveCount(2)
    await expect(results.picture('ablation')).toContainText('Without ranking')
    await expect(results.picture('ablation')).toContainText('worse without')
  })
})
