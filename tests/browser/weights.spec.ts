/** Ground that costs more than its length, and a robot that is no point. */
import { expect, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { expectClean } from './axe'
import { freshRace, RacePage } from './race_page'

/** The open field at rest, with the further tools in their place. */
async function openField(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await expect(page.getByTestId('tool-ground')).toBeVisible()
  return race
}

async function factorAt(race: RacePage, [x, y]: Cell): Promise<number> {
  const { spec, factors } = (await race.session()).scenario
  return factors?.[y * spec.width + x] ?? 1
}

const dearCells = async (race: RacePage) =>
  [...((await race.session()).scenario.factors ?? [])].filter((factor) => factor > 1).length

/** Takes the tool for ground, with its card open. */
async function openCard(page: Page): Promise<void> {
  const tool = page.getByTestId('tool-ground')
  if ((await tool.getAttribute('aria-pressed')) !== 'true') await tool.click()
  await tool.click()
  await expect(page.getByTestId('factor-3')).toBeVisible()
}

/** Tells all that the page has announced from now on. */
async function listening(page: Page): Promise<() => Promise<string[]>> {
  const region = page.getByTestId('announcement')
  const all = await region.evaluateHandle((region) => {
    const heard: string[] = []
    const options = { childList: true, characterData: true, subtree: true }
    new MutationObserver(() => heard.push(region.textContent ?? '')).observe(region, options)
    return heard
  })
  return () => all.jsonValue()
}

test.describe('weighted ground', () => {
  test('is drawn by brush, line and fill, erased, and undone', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('u')
    await race.drag([
      [10, 3],
      [10, 8],
    ])
    expect([await dearCells(race), await factorAt(race, [10, 5])]).toEqual([6, 3])
    await openCard(page)
    await page.getByTestId('factor-1.5').click()
    await page.getByTestId('ground-block').click()
    await page.keyboard.press('Escape')
    await race.drag([
      [20, 3],
      [22, 5],
    ])
    expect([await dearCells(race), await factorAt(race, [21, 4])]).toEqual([15, 1.5])
    await openCard(page)
    await page.getByTestId('factor-other').fill('12')
    await page.getByTestId('ground-fill').click()
    await page.keyboard.press('Escape')
    // All that costs the same hangs together.
    await race.drag([[21, 3]])
    expect([await factorAt(race, [22, 5]), await factorAt(race, [10, 5])]).toEqual([12, 3])
    await page.getByTestId('tool-erase').click()
    await race.drag([
      [10, 3],
      [10, 5],
    ])
    expect([await factorAt(race, [10, 4]), await factorAt(race, [10, 6])]).toEqual([1, 3])
    for (let step = 0; step < 4; step++) await page.getByTestId('undo').click()
    expect((await race.session()).scenario.factors).toBeNull()
    await page.getByTestId('redo').click()
    expect(await dearCells(race)).toBe(6)
  })

  test('is drawn with keys, and told under the cursor', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('u')
    await race.stage().focus()
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('ArrowUp')
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('announcement')).toHaveText(/ground: 1 cell changed/i)
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('ArrowLeft')
    await expect(page.getByTestId('announcement')).toHaveText(/factor 3/)
    await expect(page.getByTestId('panel-1').getByTestId('cell-readout')).toContainText('factor 3')
  })

  test('is selected, moved and copied with its map', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('u')
    await race.drag([[10, 5]])
    await page.keyboard.press('m')
    await race.drag([
      [9, 4],
      [11, 6],
    ])
    await race.drag([
      [10, 5],
      [15, 5],
    ])
    expect([await factorAt(race, [10, 5]), await factorAt(race, [15, 5])]).toEqual([1, 3])
  })

  test('makes paths cost more, which table, gap and chart say', async ({ page }) => {
    const race = await openField(page)
    await openCard(page)
    await page.getByTestId('factor-10').click()
    await page.getByTestId('ground-block').click()
    await page.keyboard.press('Escape')
    await race.drag([
      [15, 0],
      [18, 24],
    ])
    await page.getByTestId('run-to-end').click()
    await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
    const { summary } = await race.result(2)
    expect(summary?.metrics?.cost).toBeGreaterThan(summary?.metrics?.length ?? 0)
    expect(summary?.value).toBe(summary?.metrics?.cost)
    await expect(page.getByTestId('gap-2')).toContainText(/least cost/i)
    await expect(page.getByTestId('readout-value-2')).toBeVisible()
    await expect(page.getByTestId('metric-cost-2')).toHaveAttribute(
      'data-value',
      String(summary?.metrics?.cost),
    )
    await expect(page.getByTestId('legend-1')).toContainText(/× 1\b.*× 10/s)
  })

  test('is what screen readers hear of a path', async ({ page }) => {
    const race = await openField(page)
    await openCard(page)
    await page.getByTestId('ground-block').click()
    await page.keyboard.press('Escape')
    await race.drag([
      [15, 0],
      [18, 24],
    ])
    await page.getByTestId('remove-2').click()
    await page.getByTestId('planner-1').selectOption('ant-system')
    await race.ready()
    const heard = await listening(page)
    await page.getByTestId('play').click()
    const told = async () =>
      (await heard()).flatMap((text) => /first path, (.*)/.exec(text)?.[1] ?? [])[0]
    await expect.poll(told).toBeDefined()
    await page.getByTestId('play').click()
    // Of no path here is the length its cost: four columns cost three times as much.
    const { history } = await race.result(1)
    expect(history.map(([, best = Number.NaN]) => `Cost ${best.toFixed(2)}`)).toContain(
      await told(),
    )
  })

  test('is refused by planners that do not know it, by name', async ({ page }) => {
    const race = await openField(page)
    await page.keyboard.press('u')
    await race.drag([[10, 5]])
    await page.getByTestId('add-panel').click()
    const refused = page.locator('[data-testid^="add-"][aria-disabled="true"]')
    await expect(refused.filter({ hasText: /weighted ground/i }).first()).toBeVisible()
  })

  test('goes into a link and a file, and comes back', async ({ page, browser }) => {
    const race = await openField(page)
    await page.keyboard.press('u')
    await race.drag([
      [10, 3],
      [14, 8],
    ])
    const { scenario } = await race.session()
    const other = await freshRace(browser, await race.shareLink())
    expect((await other.session()).scenario.factors).toEqual(scenario.factors)
    await other.page.context().close()
  })

  test('looks its part in light and dark, and axe finds nothing', async ({ page }) => {
    const race = await openField(page)
    await openCard(page)
    await expectClean(page, 'the card of the tool for ground')
    await page.keyboard.press('Escape')
    const plain = await race.picture()
    await race.drag([
      [10, 3],
      [14, 8],
    ])
    expect((await race.picture()).equals(plain)).toBe(false)
    await page.emulateMedia({ colorScheme: 'dark' })
    await expectClean(page, 'weighted ground in the dark')
  })
})

test.describe('a robot', () => {
  async function openShape(race: RacePage): Promise<void> {
    await race.menu('map-menu', 'open-resize')
    await expect(race.page.getByTestId('robot-fields')).toBeVisible()
  }

  test('has a radius and costs near obstacles, told in its run', async ({ page }) => {
    const race = await openField(page)
    await race.drag([
      [12, 2],
      [12, 12],
    ])
    await openShape(race)
    await page.getByTestId('robot-round').click()
    await page.getByTestId('robot-radius').fill('1.5')
    await page.getByTestId('inflation-nav2-smac-2d').click()
    await page.getByTestId('inflation-radius').fill('5')
    await page.getByTestId('inflation-cost_scaling').fill('1')
    await race.applyRules()
    const inflation = { radius: 5, cost_scaling: 1, multiplier: 2, rule: 'nav2-smac-2d' }
    expect((await race.session()).scenario.spec.robot).toEqual({ radius: 1.5, inflation })
    await race.ready()
    await expect(page.getByTestId('legend-1')).toContainText(/too narrow/i)
    await race.stage().focus()
    const at = await race.pointOf([13, 5])
    await page.mouse.move(at.x, at.y)
    await expect(page.getByTestId('panel-1').getByTestId('cell-readout')).toContainText(
      /too narrow/i,
    )
    await page.getByTestId('undo').click()
    expect((await race.session()).scenario.spec.robot).toBeUndefined()
  })

  test('that does not fit at the start is offered a smaller radius, or another place', async ({
    page,
  }) => {
    const race = await openField(page)
    const { start } = (await race.session()).scenario.spec
    await race.drag([[start[0] + 1, start[1] + 1]])
    await openShape(race)
    await page.getByTestId('robot-round').click()
    await page.getByTestId('robot-radius').fill('2')
    await expect(page.getByTestId('robot-no-room')).toContainText(/does not fit at the start/i)
    await page.getByTestId('robot-smaller').click()
    await expect(page.getByTestId('robot-radius')).toHaveValue('1.414')
    await expect(page.getByTestId('robot-no-room')).toBeHidden()
    await page.getByTestId('robot-radius').fill('2')
    await page.getByTestId('robot-move').click()
    await race.applyRules()
    const moved = (await race.session()).scenario.spec
    expect(moved.start).not.toEqual(start)
    expect(moved.robot?.radius).toBe(2)
    await race.ready()

    // A wall beside the start: the offer comes with the refusal.
    await race.drag([[moved.start[0] + 1, moved.start[1]]])
    await page
      .getByTestId('toast-warning')
      .getByRole('button', { name: /move to/i })
      .click()
    await race.ready()
  })

  test('whose numbers the engine does not take is refused with its words', async ({ page }) => {
    const race = await openField(page)
    await openShape(race)
    await page.getByTestId('inflation-nav2-navfn').click()
    await page.getByTestId('inflation-cost_scaling').fill('0')
    await expect(page.getByTestId('resize-dialog').getByRole('alert')).toContainText(/above 0/i)
    await expectClean(page, 'Size, moves and robot with a robot')
  })

  test('whose radius is none is refused at its field, in its own words in Chinese', async ({
    page,
  }) => {
    const race = await openField(page)
    await openShape(race)
    await page.getByTestId('robot-round').click()
    const radius = page.getByTestId('robot-radius')
    await radius.fill('-1')
    const wrong = page.getByTestId('robot-wrong')
    await expect(wrong).toContainText(/robot\.radius = -1 cannot be used/i)
    await expect(radius).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByTestId('robot-fields')).not.toContainText('-1 cells')
    await expect(page.getByTestId('resize')).toBeDisabled()
    await radius.press('Enter')
    await expect(page.getByTestId('resize-dialog')).toBeVisible()
    expect((await race.session()).scenario.spec.robot).toBeUndefined()
    await page.keyboard.press('Escape')
    await race.menu('language', 'language-zh-CN')
    await openShape(race)
    await page.getByTestId('robot-round').click()
    await radius.fill('-1')
    await expect(wrong).toContainText('不能使用 半径（米） = -1')
  })

  test('without room is told once above the maps, in Chinese, and the offer goes once there is', async ({
    page,
  }) => {
    const race = await openField(page)
    await race.menu('language', 'language-zh-CN')
    await openShape(race)
    await page.getByTestId('robot-round').click()
    await page.getByTestId('robot-radius').fill('2')
    await race.applyRules()
    const { start } = (await race.session()).scenario.spec
    await race.drag([[start[0] + 1, start[1]]])
    const strip = page.locator('.race-strip')
    await expect(strip).toContainText('机器人在起点')
    await expect(strip).toContainText('最短路径：无，原因见旁')
    expect(await strip.innerText()).not.toMatch(/robot|obstacle/)
    const offer = page.getByTestId('toast-warning')
    await expect(offer).not.toContainText('障碍物')
    // Cured by another way than the offer.
    await page.getByTestId('undo').click()
    await expect(strip).not.toContainText('机器人在起点')
    await expect(offer).toBeHidden()
  })

  test('comes back from a link', async ({ page, browser }) => {
    const race = await openField(page)
    await openShape(race)
    await page.getByTestId('robot-round').click()
    await race.applyRules()
    const { robot } = (await race.session()).scenario.spec
    expect(robot).toBeDefined()
    const other = await freshRace(browser, await race.shareLink())
    expect((await other.session()).scenario.spec.robot).toEqual(robot)
    await other.page.context().close()
  })
})

test('in Chinese', async ({ page }) => {
  const race = await openField(page)
  await race.menu('language', 'language-zh-CN')
  await page.getByTestId('tool-ground').click()
  await race.drag([[10, 5]])
  await expect(page.getByTestId('legend-1')).toContainText('地面代价')
  await race.menu('map-menu', 'open-resize')
  await expect(page.getByTestId('robot-fields')).toContainText('机器人')
})

test('on a phone @phone', async ({ page }) => {
  const race = await openField(page)
  await openCard(page)
  await page.getByTestId('factor-5').tap()
  const card = await page.locator('#ground-card').boundingBox()
  expect((card?.x ?? -1) >= 0 && (card?.x ?? 0) + (card?.width ?? 999) <= 390).toBe(true)
  await page.keyboard.press('Escape')
  const at = await race.pointOf([10, 5])
  await page.touchscreen.tap(at.x, at.y)
  await expect.poll(() => factorAt(race, [10, 5])).toBe(5)
})
