import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test, type Worker } from '@playwright/test'
import { Lab } from './lab'
import { openTerrain } from './terrain_lab'

declare global {
  interface Window {
    /** What the spec counts: drawing calls of WebGL, and the contexts that were made. */
    draws: number
    contexts: WebGL2RenderingContext[]
  }
}

/** Counts what WebGL is asked to draw, from the page's first script on. */
async function countDraws(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.draws = 0
    window.contexts = []
    const gl = WebGL2RenderingContext.prototype
    const elements = gl.drawElements
    gl.drawElements = function (...args) {
      window.draws++
      elements.apply(this, args)
    }
    const context = HTMLCanvasElement.prototype.getContext as (...args: unknown[]) => unknown
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...args: unknown[]
    ) {
      const made = context.apply(this, args)
      if (made instanceof WebGL2RenderingContext && !window.contexts.includes(made))
        window.contexts.push(made)
      return made
    } as typeof HTMLCanvasElement.prototype.getContext
  })
}

const lostContexts = (page: Page) =>
  page.evaluate(() => window.contexts.map((context) => context.isContextLost()))

/** How bright a picture of an element is: mean, spread, how many different values of 256, share of dark pixels. */
async function light(page: Page, png: Buffer) {
  return page.evaluate(async (base64) => {
    const blob = await (await fetch(`data:image/png;base64,${base64}`)).blob()
    const bitmap = await createImageBitmap(blob)
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height)
    const context = canvas.getContext('2d')
    if (!context) throw new Error('no 2D canvas')
    context.drawImage(bitmap, 0, 0)
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height)
    const values: number[] = []
    for (let i = 0; i < data.length; i += 4)
      values.push(Math.round(((data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0)) / 3))
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length
    const spread = Math.sqrt(
      values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length,
    )
    return { mean, spread, kinds: new Set(values).size }
  }, png.toString('base64'))
}

const reliefs = (page: Page) => page.locator('.stage.relief')

/** In three dimensions, and every panel's picture has come to rest. */
async function openRelief(page: Page): Promise<void> {
  await page.getByTestId('view-solid').click()
  await expect(reliefs(page).first()).toBeVisible()
  await settled(page)
}

/** Waits until nothing has been drawn for a while. */
async function settled(page: Page): Promise<void> {
  await expect
    .poll(
      async () => {
        const before = await page.evaluate(() => window.draws)
        await page.waitForTimeout(700)
        return before > 0 && before === (await page.evaluate(() => window.draws))
      },
      { timeout: 30_000 },
    )
    .toBe(true)
}

/** Share of a panel's canvas that something is drawn on, and a number that tells pictures apart. */
function picture(page: Page, panel = 0) {
  return page.evaluate((index) => {
    const canvas = document.querySelectorAll('.stage.relief')[index]?.querySelector('canvas')
    const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data
    if (!data) throw new Error('there is no canvas')
    let [drawn, sum] = [0, 0]
    for (let i = 0; i < data.length; i += 4) {
      if ((data[i + 3] ?? 0) > 0) drawn++
      sum = (sum * 31 + (data[i] ?? 0) + 256 * (data[i + 1] ?? 0)) % 1_000_003
    }
    return { drawn: (4 * drawn) / data.length, sum }
  }, panel)
}

/** How opaque the first panel's marks are at a point of the page, 0 to 255. */
function markAt(page: Page, x: number, y: number) {
  return page.evaluate(
    ([px, py]) => {
      const overlay = document.querySelectorAll<HTMLCanvasElement>('.stage.relief canvas')[1]
      const box = overlay?.getBoundingClientRect()
      const data = overlay
        ?.getContext('2d')
        ?.getImageData((px ?? 0) - (box?.left ?? 0), (py ?? 0) - (box?.top ?? 0), 1, 1).data
      return data?.[3] ?? -1
    },
    [x, y],
  )
}

async function middleOf(page: Page, panel = 0): Promise<{ x: number; y: number }> {
  const box = await reliefs(page).nth(panel).boundingBox()
  if (!box) throw new Error('the stage is not on screen')
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

test.describe('from above', () => {
  test('a terrain is shaded and has contour lines that can be put away', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await page.getByTestId('layer').selectOption('none')
    await lab.frame()
    const withLines = await light(page, await lab.stage().screenshot())
    expect(withLines.kinds).toBeGreaterThan(100)
    expect(withLines.spread).toBeGreaterThan(15)
    const button = page.getByTestId('show-contours')
    await expect(button).toHaveAttribute('aria-pressed', 'true')
    await lab.seesMotion(1, () => button.click())
    const without = await light(page, await lab.stage().screenshot())
    expect(without.kinds).toBeGreaterThan(60)
    // The lines are darker than the ground.
    expect(withLines.mean).toBeLessThan(without.mean - 0.5)
    await expect(button).toHaveAttribute('aria-pressed', 'false')
  })

  test('a plane has none of it', async ({ page }) => {
    const lab = new Lab(page)
    await lab.openAtRest()
    await expect(page.getByTestId('view-solid')).toBeHidden()
    await expect(page.getByTestId('chart-profile')).toBeHidden()
    await page.keyboard.press('3')
    await expect(page.locator('.stage.relief')).toHaveCount(0)
    await page.mouse.move(...(Object.values(await lab.pointOf([5, 5])) as [number, number]))
    await expect(page.getByTestId('cell-readout')).toBeHidden()
  })

  test('the height of a cell is shown and said', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    const { x, y } = await lab.pointOf([30, 20])
    await page.mouse.move(x, y)
    const metres = await page.evaluate(() => {
      const now = window.formicarium.session()?.scenario
      return now?.heights?.[20 * now.spec.width + 30] ?? Number.NaN
    })
    const words = `${new Intl.NumberFormat('en', { maximumSignificantDigits: 5 }).format(metres)} m`
    await expect(page.getByTestId('cell-readout').first()).toHaveText(`30, 20 ${words}`)
    await lab.stage().focus()
    await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('announcement')).toContainText(/ m$/)
  })
})

test.describe('in three dimensions', () => {
  test.beforeEach(({ page }) => countDraws(page))

  test('every panel is drawn, with one context, and nothing is drawn at rest', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const panels = (await lab.results()).length
    await expect(reliefs(page)).toHaveCount(panels)
    for (let panel = 0; panel < panels; panel++)
      expect((await picture(page, panel)).drawn).toBeGreaterThan(0.15)
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
    await settled(page)
    expect((await picture(page, 0)).sum).not.toBe(before[0]?.sum)
    expect((await picture(page, 1)).sum).not.toBe(before[1]?.sum)
    await page.keyboard.press('Home')
    await settled(page)
    expect([await picture(page, 0), await picture(page, 1)]).toEqual(before)
  })

  test('dragging turns, the wheel zooms, heights can be exaggerated', async ({ page }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { x, y } = await middleOf(page)
    const sums = [(await picture(page)).sum]
    const changed = async () => {
      await settled(page)
      const { sum } = await picture(page)
      expect(sums).not.toContain(sum)
      sums.push(sum)
    }
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 60, y + 10, { steps: 4 })
    await page.mouse.up()
    await changed()
    await page.mouse.wheel(0, -200)
    await changed()
    await page.getByTestId('stretch').fill('6')
    await changed()
    await expect(page.getByTestId('stretch')).toHaveAttribute('aria-valuetext', '6 times as high')
  })

  test('start and goal are put where one clicks', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { x, y } = await middleOf(page)
    for (const [tool, dx] of [
      ['goal', 20],
      ['start', -30],
    ] as const) {
      await page.getByTestId(`tool-${tool}`).click()
      await page.mouse.move(x + dx, y)
      const readout = await page.getByTestId('cell-readout').first().textContent()
      await page.mouse.click(x + dx, y)
      const { spec } = (await lab.session()).scenario
      const at = tool === 'goal' ? spec.goals[0]?.at : spec.start
      expect(readout).toMatch(new RegExp(`^${at?.join(', ')} .* m$`))
      // Where the ray went, the mark is drawn.
      await page.mouse.move(x, y - 60)
      await lab.frame()
      expect(await markAt(page, x + dx, y)).toBe(255)
      expect(await markAt(page, x + dx, y + 40)).toBe(0)
    }
    // The start is taken up with any tool, as on the flat map; else the tools for walls change nothing.
    await page.getByTestId('tool-wall').click()
    const { start } = (await lab.session()).scenario.spec
    await page.mouse.move(x - 30, y)
    await page.mouse.down()
    await page.mouse.move(x - 40, y + 20, { steps: 3 })
    await page.mouse.up()
    expect((await lab.session()).scenario.spec.start).not.toEqual(start)
    await page.mouse.click(x, y + 20)
    expect(await lab.walls()).toBe(0)
  })

  test('start and goal are put down by keys alone, and their heights are said', async ({
    page,
  }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await reliefs(page).first().focus()
    await page.keyboard.press('g')
    // The first press brings the cursor to the start.
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowRight'])
      await page.keyboard.press(key)
    await expect(page.getByTestId('announcement')).toContainText(
      /^Column \d+, row \d+.*m$|\d+.* m$/,
    )
    const before = (await lab.session()).scenario.spec
    await page.keyboard.press('Enter')
    const after = (await lab.session()).scenario.spec
    expect(after.goals[0]?.at).not.toEqual(before.goals[0]?.at)
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
    const lab = new Lab(page)
    await lab.openAtRest()
    // Cells of 1 m, heights of kilometres.
    await lab.paste('ncols 3\nnrows 2\ncellsize 1\n0 1000 2000\n500 1500 3000\n')
    await page.getByTestId('terrain-open').click()
    await expect(page.getByTestId('view-solid')).toBeVisible()
    await openRelief(page)
    // 0.17 · 3 cells / 3000 cells of relief.
    await expect(page.locator('.stretch-field output')).toHaveText('0.00017×')
  })

  test('by slices Page Up and Page Down change the level of an end', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-slices')
    const level = async () => (await lab.session()).scenario.spec.terrain?.slices?.start_level
    const before = (await level()) ?? 0
    await lab.stage().focus()
    await page.keyboard.press('PageUp')
    expect(await level()).toBe(before + 1)
    await openRelief(page)
    await reliefs(page).first().focus()
    await page.keyboard.press('PageDown')
    expect(await level()).toBe(before)
  })

  test('the picture follows a run', async ({ page }) => {
    await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    const { sum } = await picture(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await settled(page)
    expect((await picture(page)).sum).not.toBe(sum)
  })

  test('the context is given back: flat again, on a plane, without panels', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await page.keyboard.press('3')
    await expect(reliefs(page)).toHaveCount(0)
    expect(await lostContexts(page)).toEqual([true])
    await expect(lab.stage().locator('canvas')).toHaveCount(1)
    await lab.seesMotion(1, () => lab.stage().press('ArrowDown'))

    await page.keyboard.press('3')
    await settled(page)
    await lab.menu('map-menu', 'gallery-open-field')
    await expect(reliefs(page)).toHaveCount(0)
    expect(await lostContexts(page)).toEqual([true, true])
    await page.getByTestId('undo').click()
    await expect(reliefs(page).first()).toBeVisible()
    while ((await lab.results()).length > 0) await page.getByTestId('remove-1').click()
    await expect.poll(() => lostContexts(page)).toEqual([true, true, true])
    await expect(page.getByTestId('toast-warning')).toBeHidden()
  })

  test('a lost context is said, and the flat map goes on', async ({ page }) => {
    const lab = await openTerrain(page, 'terrain-hills')
    await openRelief(page)
    await page.evaluate(() => window.contexts[0]?.getExtension('WEBGL_lose_context')?.loseContext())
    await expect(page.getByTestId('toast-warning')).toBeVisible()
    await expect(reliefs(page)).toHaveCount(0)
    await lab.seesMotion(1, () => lab.stage().press('ArrowDown'))
    await page.getByTestId('view-solid').click()
    await expect(reliefs(page).first()).toBeVisible()
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      await openTerrain(page, 'terrain-slices')
      await openRelief(page)
      await page.getByTestId('chart-profile').click()
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
    await settled(page)
    expect((await picture(page)).sum).not.toBe(sum)
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
  const lab = await openTerrain(page, 'terrain-hills')
  await page.getByTestId('view-solid').click()
  await expect(page.getByTestId('toast-warning')).toHaveCount(1)
  await expect(reliefs(page)).toHaveCount(0)
  await lab.seesMotion(1, () => lab.stage().press('ArrowDown'))
})

test('a 513 × 513 terrain: milliseconds a frame, to read', async ({ page }) => {
  test.slow()
  await countDraws(page)
  const lab = new Lab(page)
  await lab.openAtRest()
  await lab.menu('map-menu', 'open-generate')
  await page.getByTestId('generate-fractal').click()
  await page.getByTestId('generate-width').fill('513')
  await page.getByTestId('generate-height').fill('513')
  await page.getByTestId('generate').click()
  await expect.poll(async () => (await lab.session()).scenario.spec.width).toBe(513)
  await page.evaluate(() => window.formicarium.pause())
  await lab.ready()
  await page.waitForTimeout(1000)
  const workers = page.workers()
  for (const worker of workers) await listenToFrames(worker)
  const box = await lab.stage().boundingBox()
  if (!box) throw new Error('the stage is not on screen')
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  const report = async (what: string, act: (i: number) => Promise<void>) => {
    for (const worker of workers)
      await worker.evaluate(() => Object.assign(self, { spans: [], works: [] }))
    const spans = page.evaluate(() => {
      const all: number[] = []
      let last = performance.now()
      return new Promise<number[]>((resolve) => {
        const next = () => {
          all.push(performance.now() - last)
          last = performance.now()
          if (all.length < 60) requestAnimationFrame(next)
          else resolve(all)
        }
        requestAnimationFrame(next)
      })
    })
    for (let i = 0; i < 50; i++) await act(i)
    console.log(`513 × 513, ${what}: page ${inWords(await spans)}`)
    for (const worker of workers) {
      const { spans, works } = await worker.evaluate(
        () => self as unknown as { spans: number[]; works: number[] },
      )
      if (works.length > 0)
        console.log(`  worker: frames ${inWords(spans)}; own work ${inWords(works)}`)
    }
  }
  await page.mouse.move(x, y)
  await report('zooming', () => page.mouse.wheel(0, -30))
  await page.mouse.down({ button: 'middle' })
  await report('panning', (i) => page.mouse.move(x - 4 * i, y - 2 * i))
  await page.mouse.up({ button: 'middle' })
  await openRelief(page)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await report('turning in 3-D', (i) => page.mouse.move(x - 4 * i, y))
  await page.mouse.up()
  expect(await page.evaluate(() => window.draws)).toBeGreaterThan(0)
})

/** Notes in a panel's worker how long frames are apart, and how long a new view takes. */
function listenToFrames(worker: Worker): Promise<void> {
  return worker.evaluate(() => {
    const notes = Object.assign(self, { spans: [] as number[], works: [] as number[] })
    const before = self.onmessage
    self.onmessage = (event: MessageEvent) => {
      const began = performance.now()
      before?.call(self as never, event)
      if (event.data.kind === 'view') notes.works.push(performance.now() - began)
    }
    let last = performance.now()
    const next = () => {
      notes.spans.push(performance.now() - last)
      last = performance.now()
      self.requestAnimationFrame?.(next)
    }
    self.requestAnimationFrame?.(next)
  })
}

function inWords(all: number[]): string {
  const sorted = [...all].sort((a, b) => a - b)
  const at = (part: number) => (sorted[Math.floor(part * (sorted.length - 1))] ?? 0).toFixed(1)
  return `median ${at(0.5)}, 95 % ${at(0.95)}, worst ${at(1)} ms`
}
