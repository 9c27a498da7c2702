import { expect, type Page, test } from '@playwright/test'
import type { PanelSetup, Session } from '../../www/src/model/session'
import { packBits } from '../../www/src/share/codec'
import { seal } from '../../www/src/share/envelope'
import { RacePage } from './race_page'
import { sessionOf } from './units/sessions'
import { countCalls, ticks } from './workers'

const setup = (planner: string): PanelSetup => ({
  planner,
  preset: null,
  params: {},
  label: null,
  result: null,
})

/** A link with an empty map, which is short however large the map is. */
async function link(side: number, planners: string[]): Promise<string> {
  const plain = sessionOf(side, side, new Uint8Array(side * side))
  const session: Session = { ...plain, panels: planners.map(setup), sync: 'moves', layer: 'trail' }
  return `./#x=${await seal(packBits(session, '0.1.0'))}`
}

const phase = (page: Page) => page.getByTestId('play').getAttribute('data-phase')

test.describe('memory', () => {
  test('a large race from a link waits, says what it takes, and starts when it is asked for', async ({
    page,
  }) => {
    await countCalls(page)
    const address = await link(1536, ['ant-system', 'max-min-ant-system'])
    expect(address.length).toBeLessThan(8000)
    await page.goto(address)
    const notice = page.getByTestId('toast-warning')
    await expect(notice).toContainText(/waits.*2 panels.*0\.7 GiB/)
    await expect(page.getByTestId('panel-2')).toBeVisible()
    await page.waitForTimeout(1500)
    expect([await phase(page), await ticks(page)]).toEqual(['editing', 0])
    await notice.getByRole('button', { name: 'Start it all the same' }).click()
    await expect.poll(() => phase(page)).toBe('running')
    await expect(notice).toBeHidden()
    await expect.poll(() => ticks(page)).toBeGreaterThan(0)
  })

  test('what a tab cannot hold is refused by name, until it is smaller', async ({ page }) => {
    await countCalls(page)
    await page.goto(await link(2048, Array(6).fill('ant-system')))
    await expect(page.getByTestId('toast-warning')).toContainText('6 panels')
    await page.getByTestId('play').click()
    await expect(page.getByTestId('toast-error')).toContainText(/3\.\d GiB of memory; up to 3 GiB/)
    await expect(page.getByTestId('toast-error')).toContainText('smaller map')
    for (const key of ['ArrowRight', 'End']) await page.locator('body').press(key)
    expect([await phase(page), await ticks(page)]).toEqual(['editing', 0])
  })

  test('an ordinary link starts by itself', async ({ page }) => {
    const race = new RacePage(page)
    await race.open(await link(64, ['ant-system', 'astar']))
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
    await expect(page.getByTestId('toast-warning')).toBeHidden()
  })
})

for (const [event, key] of [
  ['drop', 'dataTransfer'],
  ['paste', 'clipboardData'],
] as const)
  test(`a file that is too large is refused unread (${event})`, async ({ page }) => {
    await new RacePage(page).openAtRest()
    const read = await page.evaluate(
      ([event, key]) => {
        let read = 0
        const file = new File(['x'], 'large.png')
        const bytes = () => {
          read++
          return Promise.resolve(new ArrayBuffer(1))
        }
        Object.defineProperty(file, 'size', { value: 64 * 1024 * 1024 + 1 })
        Object.defineProperty(file, 'arrayBuffer', { value: bytes })
        const made = new Event(event, { bubbles: true, cancelable: true })
        Object.defineProperty(made, key, { value: { types: ['Files'], items: [], files: [file] } })
        document.body.dispatchEvent(made)
        return new Promise<number>((resolve) => setTimeout(() => resolve(read), 500))
      },
      [event, key] as const,
    )
    expect(read).toBe(0)
    await expect(page.getByTestId('toast-error')).toContainText(/large.png is too large/i)
  })
