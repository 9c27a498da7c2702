/** How a gap is shown: nothing but the reference itself is shown as no gap. */
import { expect, test } from '@playwright/test'
import { gapText, relativeGap } from '../../../www/src/model/gap'

const percent = new Intl.NumberFormat('en', {
  style: 'percent',
  minimumFractionDigits: 1,
  maximumFractionDigits: 1,
  signDisplay: 'exceptZero',
})
const shown = (gap: number) => gapText(gap, percent)

test('a gap is nothing within a rounding, as the engine has it, and only then', () => {
  expect(relativeGap(100 * (1 + 9e-10), 100)).toBe(0)
  expect(relativeGap(100 * (1 + 2e-9), 100)).toBeGreaterThan(0)
  expect(relativeGap(3, 0)).toBe(0)
  expect(relativeGap(110, 100)).toBeCloseTo(0.1, 12)
})

test('what would be rounded to nothing is said to be smaller than the last digit', () => {
  expect(shown(0)).toBe('0.0%')
  expect(shown(relativeGap(100 * (1 + 2e-9), 100))).toBe('< 0.1%')
  expect(shown(0.000499)).toBe('< 0.1%')
  expect(shown(0.0005)).toBe('+0.1%')
  expect(shown(-0.000499)).toBe('> -0.1%')
  expect(shown(-0.02)).toBe('-2.0%')
})
