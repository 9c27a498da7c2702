import { expect, test, type Worker } from '@playwright/test'
import { RacePage } from './race_page'
import { countDraws, light, openRelief, openTerrain } from './terrain_page'
import { drawn } from './workers'

test.describe('from above', () => {
  test('a terrain is shaded and has contour lines that can be put away', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    await page.getByTestId('layer').selectOption('none')
    await drawn(page)
    const withLines = await light(page, await race.picture())
    expect(withLines.kinds).toBeGreaterThan(100)
    expect(withLines.spread).toBeGreaterThan(15)
    const button = page.getByTestId('show-contours')
    await expect(button).toHaveAttribute('aria-pressed', 'true')
    await race.seesMotion(1, () => button.click())
    await drawn(page)
    const without = await light(page, await race.picture())
    expect(without.kinds).toBeGreaterThan(60)
    // The lines are darker than the ground.
    expect(withLines.mean).toBeLessThan(without.mean - 0.5)
    await expect(button).toHaveAttribute('aria-pressed', 'false')
  })

  test('a plane has none of it', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await expect(page.getByTestId('view-solid')).toBeHidden()
    await expect(page.getByTestId('chart-profile')).toBeHidden()
    await page.keyboard.press('3')
    await expect(page.locator('.stage.relief')).toHaveCount(0)
    await page.mouse.move(...(Object.values(await race.pointOf([5, 5])) as [number, number]))
    await expect(page.getByTestId('cell-readout')).toBeHidden()
  })

  test('the height of a cell is shown and said', async ({ page }) => {
    const race = await openTerrain(page, 'terrain-hills')
    const { x, y } = await race.pointOf([30, 20])
    await page.mouse.move(x, y)
    const metres = await page.evaluate(() => {
      const now = window.formicarium.session()?.scenario
      return now?.heights?.[20 * now.spec.width + 30] ?? Number.NaN
    })
    const words = `${new Intl.NumberFormat('en', { maximumSignificantDigits: 5 }).format(metres)} m`
    await expect(page.getByTestId('cell-readout').first()).toHaveText(`30, 20 ${words}`)
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('announcement')).toContainText(/ m$/)
  })
})

test('a 513 × 513 terrain: milliseconds a frame, to read', async ({ page }) => {
  test.slow()
  await countDraws(page)
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'open-generate')
  await page.getByTestId('generate-fractal').click()
  await page.getByTestId('generate-width').fill('513')
  await page.getByTestId('generate-height').fill('513')
  await page.getByTestId('generate').click()
  await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(513)
  await page.evaluate(() => window.formicarium.pause())
  await race.ready()
  await page.waitForTimeout(1000)
  const workers = page.workers()
  for (const worker of workers) await listenToFrames(worker)
  const box = await race.stage().boundingBox()
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
  await page.keyboard.down('Control')
  await report('zooming', () => page.mouse.wheel(0, -30))
  await page.keyboard.up('Control')
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
