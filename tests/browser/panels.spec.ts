import { expect, type Locator, type Page, test } from '@playwright/test'
import { RacePage } from './race_page'
import { countCalls } from './workers'

/** A planner that only the whole engine has. */
const LATER = 'option[value="max-min-ant-system"]'

test.describe('panels', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('up to six, each with a worker that goes when the panel goes', async ({ page }) => {
    const race = new RacePage(page)
    // The whole engine's tools have a worker as well, which comes when the page is idle.
    await expect(page.getByTestId('planner-1').locator(LATER)).toBeAttached()
    // And so has the search for the optimum.
    await expect(page.getByTestId('optimum')).toHaveAttribute('data-value', /\d/)
    const workers = page.workers().length
    for (let count = 3; count <= 6; count++) {
      await race.menu('add-panel', count % 2 ? 'add-ant-system' : 'add-astar')
      await expect(page.getByTestId(`panel-${count}`)).toBeVisible()
    }
    await page.getByTestId('add-panel').click()
    await expect(page.getByText('At most 6 planners')).toBeVisible()
    await expect(page.getByTestId('add-astar')).toHaveAttribute('aria-disabled', 'true')
    await page.keyboard.press('Escape')
    await race.ready()
    await expect.poll(() => page.workers().length).toBe(workers + 4)
    await page.getByTestId('play').click()
    await expect
      .poll(async () => (await race.result(5)).summary?.effort.ant_moves ?? 0)
      .toBeGreaterThan(0)
    for (let count = 6; count > 1; count--) await page.getByTestId('remove-1').click()
    await expect(page.getByTestId('panel-2')).toBeHidden()
    await expect.poll(() => page.workers().length).toBeLessThanOrEqual(workers - 1)
    await page.getByTestId('remove-1').click()
    await expect(page.getByTestId('no-panels')).toBeVisible()
    await page.getByTestId('no-panels').getByRole('button').first().click()
    await expect(page.getByTestId('panel-1')).toBeVisible()
  })

  test('a panel can change its planner', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('planner-1').selectOption('astar')
    await race.ready()
    await page.locator('body').press('End')
    for (const place of [1, 2])
      await expect(page.getByTestId(`status-${place}`)).toHaveAttribute('data-status', 'optimal')
    const [first, second] = await race.results()
    expect(first?.summary?.metrics?.length).toBe(second?.summary?.metrics?.length)
  })

  test('two panels with the same planner and seed walk alike', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('planner-2').selectOption('ant-system')
    await race.ready()
    const [first, second] = await page.evaluate(() => window.formicarium.run({ iterations: 4 }))
    expect(second?.summary?.digest).toBe(first?.summary?.digest)
  })

  test('that they will walk alike is said, until one of them differs', async ({ page }) => {
    const race = new RacePage(page)
    const hint = page.getByTestId('twin-hint')
    await page.getByTestId('parameters-1').click()
    await expect(hint).toBeHidden()
    await race.menu('add-panel', 'add-ant-system')
    await expect(hint).toBeVisible()
    await page.getByTestId('param-ants').fill('7')
    await page.getByTestId('param-ants').press('Enter')
    await expect(hint).toBeHidden()
  })

  test('a refused field that is emptied or left with Escape goes back to its last good value', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await page.getByTestId('parameters-1').click()
    const field = page.getByTestId('param-rho')
    const stage = page.getByTestId('panel-1').locator('.panel-stage')
    await field.fill('0.3')
    await field.press('Enter')
    for (const leave of ['empty', 'Escape']) {
      await field.fill('1.5')
      await field.press('Enter')
      await expect(field).toHaveAttribute('aria-invalid', 'true')
      await expect(stage).toHaveAttribute('data-refused', 'true')
      if (leave === 'empty') {
        await field.fill('')
        await field.press('Tab')
      } else await field.press('Escape')
      await expect(field).toHaveValue('0.3')
      await expect(field).toHaveAttribute('aria-invalid', 'false')
      await expect(stage).toHaveAttribute('data-refused', 'false')
    }
    expect((await race.session()).panels[0]?.params.rho).toBe(0.3)
  })

  test('the bar of a colony shows how much of its iterations is done', async ({ page }) => {
    const race = new RacePage(page)
    const bars = page.getByRole('progressbar')
    await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
    const budget = (await race.result(1)).summary?.iteration_budget ?? 0
    const share = String(Math.round((100 * 5) / budget))
    await expect(bars.first()).toHaveAttribute('aria-valuenow', share)
    await page.evaluate(() => window.formicarium.run())
    await expect(bars.nth(1)).toHaveAttribute('aria-valuenow', '100')
  })

  test('a parameter out of range is refused at its field and over the map, by name, and can be mended', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await page.getByTestId('parameters-1').click()
    const field = page.getByTestId('param-rho')
    await field.fill('1.5')
    await field.press('Enter')
    await expect(
      page
        .getByRole('alert')
        .filter({ hasText: /rho|ρ|evaporation/i })
        .first(),
    ).toContainText('1.5')
    await expect(field).toHaveAttribute('aria-invalid', 'true')
    // Over the map as well: a column may be closed, or show another panel.
    await page.getByTestId('parameters-2').click()
    await expect(field).toBeHidden()
    const trouble = page.getByTestId('panel-1').getByRole('alert')
    await expect(trouble).toContainText('1.5')
    await trouble.getByRole('button', { name: 'Show the parameter' }).click()
    await field.fill('0.2')
    await field.press('Enter')
    await expect(field).toHaveAttribute('aria-invalid', 'false')
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('a parameter changes the run', async ({ page }) => {
    const race = new RacePage(page)
    await page.getByTestId('parameters-1').click()
    await page.getByTestId('param-ants').fill('7')
    await page.getByTestId('param-ants').press('Enter')
    await race.ready()
    await page.getByTestId('step-iteration').click()
    await expect.poll(async () => (await race.result(1)).summary?.ants).toBe(7)
  })

  test('a worker that fails can be started again, and nothing drawn is lost', async ({ page }) => {
    const race = new RacePage(page)
    const walls = await race.walls()
    for (const worker of page.workers()) {
      await worker
        .evaluate(() =>
          setTimeout(() => {
            throw new Error('a fault made for the test')
          }),
        )
        .catch(() => {})
    }
    // All of them: one that fails after the others have begun again stays as it is.
    for (const place of [1, 2])
      await expect(page.getByTestId(`panel-${place}`).getByRole('alert')).toBeVisible()
    expect(await race.walls()).toBe(walls)
    await page.getByTestId('panel-1').getByRole('alert').getByRole('button').click()
    await race.ready()
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('resizing the window keeps map and pointer together', async ({ page }) => {
    const race = new RacePage(page)
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    for (const width of [900, 1600, 1100]) {
      await page.setViewportSize({ width, height: 800 })
      await page.waitForFunction((wanted) => innerWidth === wanted, width)
      await race.frame()
      await race.frame()
      await race.drag([[20, 12]])
      await expect.poll(() => race.isWall([20, 12])).toBe(true)
      await race.drag([[20, 12]])
      await expect.poll(() => race.walls()).toBe(0)
    }
  })
})

test.describe('planners that come while the page is idle', () => {
  /** Holds back every engine but the first until it is let pass; tells when it has been asked for. */
  async function holdWhole(page: Page): Promise<{ asked: Promise<void>; pass: () => void }> {
    let [ask, pass] = [() => {}, () => {}]
    const asked = new Promise<void>((resolve) => {
      ask = resolve
    })
    const passed = new Promise<void>((resolve) => {
      pass = resolve
    })
    let core = ''
    await page.route(/\.wasm$/, async (route) => {
      core ||= route.request().url()
      if (route.request().url() !== core) {
        ask()
        await passed
      }
      await route.continue()
    })
    return { asked, pass }
  }

  /** Opens the page and types into a field while the whole engine is on its way; `pass` resolves when its planners are known. */
  async function typing(page: Page): Promise<{ field: Locator; pass: () => Promise<void> }> {
    await countCalls(page)
    const whole = await holdWhole(page)
    await new RacePage(page).openAtRest()
    await whole.asked
    await page.getByTestId('parameters-1').click()
    const field = page.getByTestId('param-ants')
    await field.click()
    await field.press('Control+a')
    await field.pressSequentially('3')
    const pass = async () => {
      whole.pass()
      await page.waitForFunction(() => window.answered.catalog === 2)
      await new RacePage(page).frame()
    }
    return { field, pass }
  }

  test('leave alone what is being typed, and come when the field is left', async ({ page }) => {
    const { field, pass } = await typing(page)
    await pass()
    await expect(field).toHaveValue('3')
    await field.pressSequentially('7')
    await expect(field).toHaveValue('37')
    await expect(page.getByTestId('planner-1').locator(LATER)).toHaveCount(0)
    await field.press('Tab')
    await expect(page.getByTestId('planner-1').locator(LATER)).toHaveCount(1)
    expect((await new RacePage(page).session()).panels[0]?.params.ants).toBe(37)
  })

  test('come at once when a map or a menu asks for them, whoever types', async ({ page }) => {
    const { field, pass } = await typing(page)
    await pass()
    await expect(field).toBeFocused()
    // Not by a click: it would take the focus from the field.
    await page.getByTestId('gallery-terrain-hills').evaluate((item: HTMLElement) => item.click())
    await expect(page.getByTestId('planner-1').locator(LATER)).toHaveCount(1)
  })
})

test('beside two verdicts the buttons of a panel stay in it', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  await page.goto(await race.shareLink())
  await expect(page.getByTestId('verified-2')).toBeVisible()
  await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
  for (const place of [1, 2]) {
    const card = await page.getByTestId(`panel-${place}`).boundingBox()
    const close = await page.getByTestId(`remove-${place}`).boundingBox()
    expect((close?.x ?? 0) + (close?.width ?? 0)).toBeLessThanOrEqual(
      (card?.x ?? 0) + (card?.width ?? 0),
    )
  }
})
