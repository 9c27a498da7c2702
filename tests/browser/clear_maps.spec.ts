/** What stands beside the maps leaves them free: cards of lessons, legends; and the comparison is read without scrolling sideways. */
import { expect, type Locator, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { expectClean } from './axe'
import { RacePage } from './race_page'

async function raceWith(page: Page, count: number): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  const more = ['max-min-ant-system', 'ant-colony-system', 'dijkstra', 'theta-star']
  for (const id of more.slice(0, count - 2)) {
    await page.getByTestId('add-panel').click()
    await page.getByTestId(`add-${id}`).evaluate((item: HTMLElement) => item.click())
  }
  await race.ready()
  await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
  return race
}

async function boxOf(element: Locator) {
  const box = await element.boundingBox()
  if (!box) throw new Error('it is not on the page')
  return box
}

type Box = { x: number; y: number; width: number; height: number }

const overlap = (a: Box, b: Box) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height

/** The card covers no map that is in sight, and the map it is about is there as a whole. */
async function expectClear(page: Page, card: Locator, place = 1): Promise<void> {
  const grid = await boxOf(page.locator('.panel-grid'))
  const box = await boxOf(card)
  expect(overlap(grid, box), 'over the maps').toBe(false)
  const panel = await boxOf(page.getByTestId(`panel-${place}`))
  expect(panel.y).toBeGreaterThanOrEqual(grid.y)
  expect(panel.y + panel.height).toBeLessThanOrEqual(grid.y + grid.height + 1)
  const stage = await boxOf(page.getByTestId(`panel-${place}`).locator('.stage'))
  expect(stage.height).toBeGreaterThan(190)
}

for (const [width, height] of [
  [1440, 900],
  [1280, 720],
  [768, 1024],
  [844, 390],
  [390, 844],
] as const)
  test(`at ${width} × ${height} the card of a lesson covers no map, and folds to a line`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height })
    const count = height < 500 ? 1 : 4
    const race = await raceWith(page, Math.max(2, count))
    if (count === 1) await page.getByTestId('remove-2').click()
    const compact = (await page.locator('html').getAttribute('data-compact')) === 'true'
    await race.menu('lesson-menu', 'lesson-draw')
    const card = page.getByTestId('draw-card')
    await expect(card).toBeVisible()
    const clear = () => (height < 500 ? beside(page, card) : expectClear(page, card))
    await expect(clear).toPass()
    // What is said on the card changes its size no more than the maps'.
    const [before, map] = [await boxOf(card), await boxOf(race.stage())]
    const { start } = (await race.session()).scenario.spec
    await race.drag([start, [start[0] + 1, start[1]]])
    await expect(page.getByTestId('draw-standing')).toContainText('1 step')
    expect(await boxOf(card)).toEqual(before)
    expect(await boxOf(race.stage())).toEqual(map)
    await page.getByTestId('card-fold').click()
    await expect.poll(async () => (await boxOf(card)).height).toBeLessThan(50)
    await expect(card).toContainText('1 step')
    await expect(page.getByTestId('card-fold')).toHaveAttribute('aria-expanded', 'false')
    await page.getByTestId('card-fold').click()
    await page.getByTestId('draw-done').click()
    if (compact) return
    await page.getByTestId('column').click()
    await race.menu('lesson-menu', 'lesson-follow')
    await expect(page.getByTestId('ant-where')).toBeVisible()
    await expect(() => expectClear(page, page.getByTestId('ant-card'))).toPass()
    await page.getByTestId('focus-1').click()
    await expect(() => expectClear(page, page.getByTestId('ant-card'))).toPass()
  })

async function beside(page: Page, card: Locator): Promise<void> {
  expect(overlap(await boxOf(page.locator('.panel-grid')), await boxOf(card))).toBe(false)
}

test('a followed ant in a panel out of sight is brought into it, and in a magnified map as well', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 })
  const race = await raceWith(page, 4)
  await race.menu('lesson-menu', 'lesson-follow')
  await expect(page.getByTestId('ant-where')).toBeVisible()
  await page.getByTestId('ant-panel').selectOption({ index: 2 })
  await expect(page.getByTestId('ant-where')).toContainText('Ant Colony System')
  await expect(() => expectClear(page, page.getByTestId('ant-card'), 4)).toPass()
  const stage = await boxOf(race.stage(4))
  await page.mouse.move(stage.x + stage.width - 30, stage.y + 30)
  await page.keyboard.down('Control')
  for (let i = 0; i < 8; i++) await page.mouse.wheel(0, -200)
  await page.keyboard.up('Control')
  await page.getByTestId('ant-step').click()
  await expect(page.getByTestId('ant-ahead')).toHaveAttribute('data-ahead', '1')
  const ant = page.getByTestId('panel-4').locator('.ant-trail .ant')
  await expect(async () => {
    expect(overlap(await boxOf(ant), await boxOf(race.stage(4)))).toBe(true)
  }).toPass()
})

test('a legend goes out of the way of a goal, and stays where it is while a press lasts', async ({
  page,
}) => {
  const race = await raceWith(page, 4)
  const legend = page.getByTestId('panel-1').locator('.layer-legend')
  await expect(legend).toBeVisible()
  const { width, height } = (await race.session()).scenario.spec
  const goalAt = async (cell: Cell) => {
    await page.locator('body').press('g')
    await race.drag([cell])
  }
  for (const cell of [
    [width - 1, height - 1],
    [0, height - 1],
    [width - 3, height - 1],
  ] satisfies Cell[]) {
    await goalAt(cell)
    await expect(legend).toBeVisible()
    const { x, y } = await race.pointOf(cell)
    const marker = { x: x - 11, y: y - 11, width: 22, height: 22 }
    expect(overlap(await boxOf(legend), marker)).toBe(false)
  }
  const before = await legend.getAttribute('data-side')
  const [from, to] = [await race.pointOf([width - 3, height - 1]), await race.pointOf([1, 0])]
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  for (const at of [to, await race.pointOf([1, height - 1])]) {
    await page.mouse.move(at.x, at.y, { steps: 4 })
    await race.frame()
    expect(await legend.getAttribute('data-side')).toBe(before)
  }
  await page.mouse.up()
})

test('six planners are compared without scrolling sideways, in both languages', async ({
  page,
}) => {
  await page.setViewportSize({ width: 1280, height: 720 })
  await raceWith(page, 6)
  const table = page.locator('.comparison .table-scroll')
  const wide = () => table.evaluate((element) => element.scrollWidth - element.clientWidth)
  await expect(table.locator('tbody tr')).toHaveCount(6)
  await expect(page.getByTestId('metric-gap-1')).toHaveAttribute('data-value', /\d/)
  await expect(page.getByTestId('metric-digest-6')).toBeHidden()
  for (const language of ['en', 'zh-CN']) {
    await page.getByTestId('language').click()
    await page.getByTestId(`language-${language}`).click()
    await expect(page.locator('html')).toHaveAttribute('lang', language)
    expect(await wide()).toBe(0)
    await page.getByTestId('all-metrics').click()
    await expect(page.getByTestId('metric-digest-6')).toBeVisible()
    expect(await wide()).toBe(0)
    await expectClean(page, 'six planners side by side')
    await page.getByTestId('all-metrics').click()
  }
})
