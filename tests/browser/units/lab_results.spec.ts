import { expect, test } from '@playwright/test'
import { LOOKS } from '../../../www/src/figures/look'
import { SYMBOLS, symbolPath } from '../../../www/src/figures/point_symbols'
import { endsOf, limitsOf, placed } from '../../../www/src/lab/figures/curve_limits'
import { seriesOf } from '../../../www/src/lab/figures/figure_style'
import { groups } from '../../../www/src/lab/figures/rank_groups'
import { jitter, whiskers } from '../../../www/src/lab/figures/whiskers_and_jitter'
import { effectOf, pairTest, shownEffect } from '../../../www/src/lab/results/pair_tests'

const pair = (first: number, second: number, holm: number) => ({ first, second, p: holm / 2, holm })
const point = (x: number, lower: number | null, median: number | null, upper: number | null) => ({
  x,
  lower,
  median,
  upper,
})

/** As WCAG 2 defines it; 3 is asked for what is drawn. */
function contrast(a: string, b: string): number {
  const [dark = 0, light = 0] = [luminance(a), luminance(b)].sort((x, y) => x - y)
  return (light + 0.05) / (dark + 0.05)
}

function luminance(colour: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const share = Number.parseInt(colour.slice(at, at + 2), 16) / 255
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4
  })
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue
}

test.describe('figures of results', () => {
  test('bars join neighbours of which no two differ', () => {
    const order = [4, 0, 2, 1].map((entry) => ({ entry }))
    // 4 and 1 differ, and so do 4 and 2: 4 with 0, and 0 with 2 and 1.
    const pairs = [
      pair(1, 4, 0.01),
      pair(2, 4, 0.04),
      pair(0, 4, 0.3),
      pair(0, 1, 0.05),
      pair(1, 2, 1),
    ]
    expect(groups(order, { pairs })).toEqual([
      [0, 1],
      [1, 3],
    ])
    expect(groups(order, { pairs: [] })).toEqual([[0, 3]])
    const all = order.flatMap((a, i) =>
      order.slice(i + 1).map((b) => pair(a.entry, b.entry, 0.001)),
    )
    expect(groups(order, { pairs: all })).toEqual([])
  })

  test('a run stands where its seed puts it', () => {
    const heights = Array.from({ length: 200 }, (_, seed) => jitter(seed))
    expect(Math.min(...heights)).toBeGreaterThanOrEqual(-1)
    expect(Math.max(...heights)).toBeLessThan(1)
    expect(new Set(heights).size).toBe(200)
    expect(jitter(17)).toBe(jitter(17))
  })

  test('whiskers stop at the last run within 1.5 interquartile ranges', () => {
    // Quartiles 10 and 12: whiskers reach from 7 to 15 at most. 16 is beyond, a run without a path is nowhere.
    const summary = { lower: 10, upper: 12 } as Parameters<typeof whiskers>[1]
    expect(whiskers([7.5, 10, null, 11, 12, 14, 16], summary)).toEqual({ low: 7.5, high: 14 })
    expect(whiskers([10, 12], summary)).toEqual({ low: 10, high: 12 })
  })

  test('what took no effort is drawn at the edge of a logarithmic scale', () => {
    const ends = endsOf([0, 40, 5, 300], true)
    expect(ends).toEqual({ first: 5, last: 300 })
    expect(endsOf([0, 40, 5, 300], false)).toEqual({ first: 0, last: 300 })
    expect(endsOf([0, 0], true)).toEqual({ first: 1, last: 10 })
    expect(placed([{ x: 0, y: 3 }], ends)).toEqual([{ x: 5, y: 3 }])
    // Of what happened before the first place in sight, the last counts.
    const steps = [1, 4, 9].map((x) => ({ x, y: -x }))
    expect(placed(steps, ends)).toEqual([
      { x: 5, y: -4 },
      { x: 9, y: -9 },
    ])
  })

  test('first paths that are far too long are cut off, and only they', () => {
    const long = [point(1, 60, 80, null), point(9, 29, 30, 31)]
    const short = [point(1, 33, 35, 40), point(9, 28, 28, 28.5)]
    // 2.5 times 31 − 28 above 31.
    expect(limitsOf([long, short], [28])).toMatchObject({ high: 38.5, most: 80 })
    expect(limitsOf([short], [28])).toMatchObject({ most: 40 })
    const close = [point(1, 28.4, 28.5, 28.6), point(9, 28, 28, 28.5)]
    expect(limitsOf([close], [])).toMatchObject({ high: 28.6, most: 28.6 })
  })

  test('a test reads the same from both sides', () => {
    const test = { statistic: 3, p: 0.01 }
    const only = {
      first: 2,
      second: 5,
      a12: 0.8,
      paired: true,
      wilcoxon: test,
      wilcoxon_holm: 0.02,
      mann_whitney: test,
      mann_whitney_holm: 0.03,
    }
    // A = 0.8: a run of the first is mostly the better one.
    const map = { pairs: [only] }
    expect(pairTest(map, 2, 5, 'wilcoxon')).toEqual({ better: 0.8, p: 0.02, paired: true })
    expect(pairTest(map, 5, 2, 'mann-whitney')?.better).toBeCloseTo(0.2, 12)
    expect(pairTest(map, 5, 2, 'mann-whitney')?.p).toBe(0.03)
    expect(pairTest(map, 2, 2, 'wilcoxon')).toBeNull()
  })

  test('words for A are those of Vargha and Delaney', () => {
    expect([0.5, 0.55, 0.57, 0.63, 0.65, 0.7, 0.72, 0.28, 0.02].map(effectOf)).toEqual([
      'negligible',
      'negligible',
      'small',
      'small',
      'medium',
      'medium',
      'large',
      'large',
      'large',
    ])
  })

  test('an effect has a name only where chance is ruled out', () => {
    const pair = (better: number, p: number | null) => ({ better, p, paired: true })
    expect(shownEffect(pair(0.8, 0.049))).toBe('large')
    expect(shownEffect(pair(0.52, 0.01))).toBe('negligible')
    // However far A is from ½; 5 % itself is not below 5 %, and without a test nothing is ruled out.
    for (const p of [0.05, 0.4, null]) expect(shownEffect(pair(0.98, p))).toBe('unknown')
  })

  test('no two of forty entries look alike', () => {
    const all = Array.from({ length: 40 }, (_, i) => seriesOf(i, `Entry ${i}`))
    const looks = [
      ['colour', 'symbol'],
      ['colour', 'dash'],
      // For who sees no colour, and on paper without any.
      ['symbol', 'dash'],
    ] as const
    for (const [a, b] of looks)
      expect(new Set(all.map((one) => `${one[a]} ${one[b]}`)).size, `${a}, ${b}`).toBe(40)
    expect(new Set(all.map(({ colour }) => colour)).size).toBe(10)
    // The first one's colour comes again, in other dashes.
    expect(all[10]?.colour).toBe(all[0]?.colour)
    expect(all[10]?.dash).not.toBe(all[0]?.dash)
    // Diamonds are published numbers.
    expect(all.map(({ symbol }) => symbol)).not.toContain('diamond')
  })

  test('every colour stands on white and on dark', () => {
    for (let i = 0; i < 10; i++)
      for (const { background } of Object.values(LOOKS))
        expect(contrast(seriesOf(i, '').colour, background), `${i}`).toBeGreaterThanOrEqual(3)
  })

  test('symbols are closed shapes about their middle', () => {
    for (const name of [...SYMBOLS, 'diamond'] as const) {
      const path = symbolPath(name, 4)
      expect(path).toMatch(/^M.*Z$/)
      expect(path).not.toMatch(/NaN|undefined/)
    }
  })
})
