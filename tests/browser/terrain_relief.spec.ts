import AxeBuilder from '@axe-core/playwright'
import { expect, test } from '@playwright/test'
import { RacePage } from './race_page'
import {
  countDraws,
  lostContexts,
  markAt,
  middleOf,
  openRelief,
  openTerrain,
  picture,
  reliefs,
  settled,
} from './terrain_page'
import { drawn } from './workers'

test.describe('in three dimensions', () => {
  test.beforeEach(({ page }) => countDraws(page))

  test('every panel is drawn, with one context, and nothing is drawn at rest', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const panels = (await race.results()).length
    await expect(reliefs(page)).toHaveCount(panels)
    for (let panel = 0; panel < panels; panel++)
      await expect.poll(async () => (await picture(page, panel)).drawn).toBeGreaterThan(0.15)
    expect(await lostContexts(page)).toEqual([false])
    const before = await page.evaluate(() => window.draws)
    await page.waitForTimeout(1500)
    expect(await page.evaluate(() => window.draws)).toBe(before)
  })

  test('arrow keys turn all panels, Home brings the whole map back', async ({ page }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const before = [await picture(page, 0), await picture(page, 1)]
    await reliefs(page).first().focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('ArrowUp')
    await page.keyboard.press('+')
    for (const panel of [0, 1])
      await expect.poll(async () => (await picture(page, panel)).sum).not.toBe(before[panel]?.sum)
    await page.keyboard.press('Home')
    const both = async () => [await picture(page, 0), await picture(page, 1)]
    await expect.poll(both).toEqual(before)
  })

  test('dragging turns, the wheel zooms, heights can be exaggerated', async ({ page }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { x, y } = await middleOf(page)
    const sums = [(await picture(page)).sum]
    const changed = async () => {
      await expect.poll(async () => sums.includes((await picture(page)).sum)).toBe(false)
      await settled(page)
      sums.push((await picture(page)).sum)
    }
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 60, y + 10, { steps: 4 })
    await page.mouse.up()
    await changed()
    await page.keyboard.down('Control')
    await page.mouse.wheel(0, -200)
    await page.keyboard.up('Control')
    await changed()
    await page.getByTestId('stretch').fill('6')
    await changed()
    await expect(page.getByTestId('stretch')).toHaveAttribute('aria-valuetext', '6 times as high')
  })

  test('start and goal are put where one clicks', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { x, y } = await middleOf(page)
    for (const [tool, dx] of [
      ['goal', 20],
      ['start', -30],
    ] as const) {
      await page.getByTestId(`tool-${tool}`).click()
      await page.mouse.move(x + dx, y)
      const readout = page.getByTestId('cell-readout').first()
      await expect(readout).toHaveText(/^\d+, \d+ .* m$/)
      const end = async () => {
        const { spec } = (await race.session()).scenario
        return tool === 'goal' ? spec.goals[0]?.at : spec.start
      }
      const before = await end()
      await page.mouse.click(x + dx, y)
      await expect.poll(end).not.toEqual(before)
      await expect(readout).toHaveText(new RegExp(`^${(await end())?.join(', ')} .* m$`))
      // Where the ray went, the mark is drawn.
      await page.mouse.move(x, y - 60)
      await expect.poll(() => markAt(page, x + dx, y)).toBe(255)
      expect(await markAt(page, x + dx, y + 40)).toBe(0)
    }
    // The start is taken up with any tool, as on the flat map; else the tools for walls change nothing.
    await page.getByTestId('tool-wall').click()
    const { start } = (await race.session()).scenario.spec
    await page.mouse.move(x - 30, y)
    await page.mouse.down()
    await page.mouse.move(x - 40, y + 20, { steps: 3 })
    await page.mouse.up()
    await expect.poll(async () => (await race.session()).scenario.spec.start).not.toEqual(start)
    await page.mouse.click(x, y + 20)
    expect(await race.walls()).toBe(0)
  })

  test('start and goal are put down by keys alone, and their heights are said', async ({
    page,
  }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await reliefs(page).first().focus()
    await page.keyboard.press('g')
    // The first press brings the cursor to the start.
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowRight'])
      await page.keyboard.press(key)
    await expect(page.getByTestId('announcement')).toContainText(
      /^Column \d+, row \d+.*m$|\d+.* m$/,
    )
    const goal = async () => (await race.session()).scenario.spec.goals[0]?.at
    const before = await goal()
    await page.keyboard.press('Enter')
    await expect.poll(goal).not.toEqual(before)
    // With the tool for walls the cursor goes with Shift.
    await page.keyboard.press('w')
    const said = await page.getByTestId('announcement').textContent()
    await page.keyboard.press('Shift+ArrowDown')
    await expect(page.getByTestId('announcement')).not.toHaveText(said ?? '')
  })

  test('marks follow the theme, and a click with the tool for walls leads to the flat map', async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme: 'light' })
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const marks = () =>
      page.evaluate(() => {
        const overlay = document.querySelectorAll<HTMLCanvasElement>('.stage.relief canvas')[1]
        const data = overlay?.getContext('2d')?.getImageData(0, 0, overlay.width, overlay.height)
        return data?.data.reduce(
          (sum, value, i) => (sum * 31 + value * (1 + (i % 4))) % 1_000_003,
          7,
        )
      })
    const light = await marks()
    await page.emulateMedia({ colorScheme: 'dark' })
    await expect.poll(marks).not.toBe(light)
    await page.getByTestId('tool-wall').click()
    const { x, y } = await middleOf(page)
    await page.mouse.click(x, y)
    const told = page.getByTestId('toast-info').filter({ hasText: 'Walls are drawn' })
    await told.getByRole('button', { name: 'See the map from above' }).click()
    await expect(reliefs(page)).toHaveCount(0)
  })

  test('ground that is flattened says by how much', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    // Cells of 1 m, heights of kilometres.
    await race.paste('ncols 3\nnrows 2\ncellsize 1\n0 1000 2000\n500 1500 3000\n')
    await page.getByTestId('terrain-open').click()
    await expect(page.getByTestId('view-solid')).toBeVisible()
    await openRelief(page)
    // 0.17 · 3 cells / 3000 cells of relief.
    await expect(page.locator('.stretch-field output')).toHaveText('0.00017×')
  })

  test('by slices Page Up and Page Down change the level of an end', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-slices')
    const level = async () => (await race.session()).scenario.spec.terrain?.slices?.start_level
    const before = (await level()) ?? 0
    await race.stage().focus()
    await page.keyboard.press('PageUp')
    await expect.poll(level).toBe(before + 1)
    await openRelief(page)
    await reliefs(page).first().focus()
    await page.keyboard.press('PageDown')
    await expect.poll(level).toBe(before)
  })

  test('the picture follows a run', async ({ page }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { sum } = await picture(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await expect.poll(async () => (await picture(page)).sum).not.toBe(sum)
  })

  test('the context is given back: flat again, on a plane, without panels', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await page.keyboard.press('3')
    await expect(reliefs(page)).toHaveCount(0)
    await expect.poll(() => lostContexts(page)).toEqual([true])
    await expect(race.stage().locator('canvas')).toHaveCount(1)
    await drawn(page)
    await race.seesMotion(1, () => race.stage().press('ArrowDown'))

    await page.keyboard.press('3')
    await expect(reliefs(page).first()).toBeVisible()
    await settled(page)
    await race.menu('map-menu', 'gallery-open-field')
    await expect(reliefs(page)).toHaveCount(0)
    await expect.poll(() => lostContexts(page)).toEqual([true, true])
    await page.getByTestId('undo').click()
    await expect(reliefs(page).first()).toBeVisible()
    while ((await race.results()).length > 0) await page.getByTestId('remove-1').click()
    await expect.poll(() => lostContexts(page)).toEqual([true, true, true])
    await expect(page.getByTestId('toast-warning')).toBeHidden()
  })

  test('a lost context is said, and the flat map goes on', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await page.evaluate(() => window.contexts[0]?.getExtension('WEBGL_lose_context')?.loseContext())
    await expect(page.getByTestId('toast-warning')).toBeVisible()
    await expect(reliefs(page)).toHaveCount(0)
    await expect(race.stage().locator('canvas')).toHaveCount(1)
    await drawn(page)
    await race.seesMotion(1, () => race.stage().press('ArrowDown'))
    await page.getByTestId('view-solid').click()
    await expect(reliefs(page).first()).toBeVisible()
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      await openTerrain(page, 'terrain-slices')
      await openRelief(page)
      await page.getByTestId('chart-profile').click()
      await expect(page.locator('.plot-hint')).toBeVisible()
      const { violations } = await new AxeBuilder({ page }).analyze()
      const serious = violations.filter(
        ({ impact }) => impact === 'serious' || impact === 'critical',
      )
      expect(serious.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([])
    })
  }

  test('a finger turns it on a phone, and nothing is wider than the screen @phone', async ({
    page,
  }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await reliefs(page).first().scrollIntoViewIfNeeded()
    const { sum } = await picture(page)
    const { x, y } = await middleOf(page)
    const cdp = await page.context().newCDPSession(page)
    const send = (
      type: 'touchStart' | 'touchMove' | 'touchEnd',
      points: { x: number; y: number }[],
    ) => cdp.send('Input.dispatchTouchEvent', { type, touchPoints: points })
    await send('touchStart', [{ x, y }])
    await send('touchMove', [{ x: x + 40, y }])
    await send('touchMove', [{ x: x + 70, y }])
    await send('touchEnd', [])
    await expect.poll(async () => (await picture(page)).sum).not.toBe(sum)
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    expect(overflow).toBeLessThanOrEqual(0)
  })
})

test('without WebGL the flat map stays, and that is said', async ({ page }) => {
  await page.addInitScript(() => {
    const context = HTMLCanvasElement.prototype.getContext as (...args: unknown[]) => unknown
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...args: unknown[]
    ) {
      return String(args[0]).startsWith('webgl') ? null : context.apply(this, args)
    } as typeof HTMLCanvasElement.prototype.getContext
  })
  const race = await openTerrain(page, 'terrain-hills')
  await page.getByTestId('view-solid').click()
  await expect(page.getByTestId('toast-warning')).toHaveCount(1)
  await expect(reliefs(page)).toHaveCount(0)
  await expect(race.stage().locator('canvas')).toHaveCount(1)
  await drawn(page)
  await race.seesMotion(1, () => race.stage().press('ArrowDown'))
})
