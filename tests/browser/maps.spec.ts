import { expect, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

const MATRIX = ['0 0 0 0 0 0', '0 1 1 1 1 0', '0 1 0 0 1 0', '0 0 0 1 0 0'].join('\n')
const MOVINGAI = [
  'type octile',
  'height 4',
  'width 6',
  'map',
  '......',
  '.@@@@.',
  '.@..T.',
  '...@..',
  '',
].join('\n')
const SCEN = `version 1\n0\tsmall.map\t6\t4\t0\t0\t5\t3\t6.82842712\n1\tsmall.map\t6\t4\t0\t3\t5\t0\t6.82842712\n`

const EXPECTED = { width: 6, height: 4, walls: 7 }

test.describe('import', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  const ways: [string, (race: RacePage, name: string, text: string) => Promise<void>][] = [
    ['by button', (race, name, text) => race.importByButton(name, text)],
    ['by drop', (race, name, text) => race.drop(name, text)],
    ['by paste', (race, _name, text) => race.paste(text)],
  ]
  for (const [way, bring] of ways) {
    for (const [name, text] of [
      ['small.txt', MATRIX],
      ['small.map', MOVINGAI],
      ['dos.map', MOVINGAI.replaceAll('\n', '\r\n')],
    ] as const) {
      test(`${name} ${way} is shown and runs`, async ({ page }) => {
        const race = new RacePage(page)
        await bring(race, name, text)
        await expect
          .poll(async () => (await race.session()).scenario.spec.width)
          .toBe(EXPECTED.width)
        expect((await race.session()).scenario.spec.height).toBe(EXPECTED.height)
        expect(await race.walls()).toBe(EXPECTED.walls)
        await page.locator('body').press('End')
        await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
      })
    }
  }

  test('a scenario written by us comes back whole', async ({ page }) => {
    const race = new RacePage(page)
    await race.menu('map-menu', 'gallery-engine-room')
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(46)
    const before = (await race.session()).scenario
    const text = await exported(race, 'scenario')
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.importByButton('plan.scenario.json', text)
    await expect.poll(() => race.walls()).toBeGreaterThan(0)
    const after = (await race.session()).scenario
    expect(after.spec).toEqual(before.spec)
    expect(after.cells).toEqual(before.cells)
  })

  test('a .scen file offers its lines for the map it belongs to', async ({ page }) => {
    const race = new RacePage(page)
    await race.importByButton('small.map.scen', SCEN)
    await expect(page.getByTestId('toast-warning')).toContainText('small.map')
    await page.keyboard.press('Escape')
    await race.drop('small.map', MOVINGAI)
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(6)
    await race.drop('small.map.scen', SCEN)
    const lines = page.getByTestId('scen-dialog').getByRole('row')
    await lines.last().getByRole('button').click()
    const ends = async () => {
      const { start, goals } = (await race.session()).scenario.spec
      return [start, goals[0]?.at]
    }
    await expect.poll(ends).toEqual([
      [0, 3],
      [5, 0],
    ])
  })

  test('swamp is given a factor, or is as free as any other ground', async ({ page }) => {
    const race = new RacePage(page)
    const swamp = MOVINGAI.replace('...@..', '.S.@SS')
    const { factors: none } = (await race.session()).scenario
    expect(none).toBeNull()
    await race.drop('small.map', swamp)
    await expect(page.getByTestId('map-swamp')).toHaveValue('1')
    await expect(page.getByTestId('map-notices')).toContainText('3 cells of swamp')
    await page.getByTestId('map-swamp').fill('0.5')
    await expect(page.getByTestId('map-dialog').getByRole('alert')).toContainText('1 to 1000')
    await expect(page.getByTestId('map-open')).toBeDisabled()
    await page.getByTestId('map-swamp').fill('2.5')
    await expect(page.getByTestId('map-notices')).toContainText('factor 2.5')
    await expectClean(page, 'a map with swamp')
    await page.getByTestId('map-open').click()
    await expect(page.getByTestId('map-dialog')).toBeHidden()
    const { spec, factors } = (await race.session()).scenario
    expect(spec.width).toBe(6)
    expect(
      [...(factors ?? [])].flatMap((factor, i) => (factor === 1 ? [] : [[i, factor]])),
    ).toEqual([
      [19, 2.5],
      [22, 2.5],
      [23, 2.5],
    ])
    await race.drop('small.map', swamp)
    await page.getByTestId('map-open').click()
    await expect.poll(async () => (await race.session()).scenario.factors).toBeNull()
  })

  test('what cannot be read is refused with line and hint, and nothing on screen is lost', async ({
    page,
  }) => {
    const race = new RacePage(page)
    const walls = await race.walls()
    for (const text of [
      '0 0 0\n0 0\n',
      'type octile\nheight 9\nwidth 2\nmap\n..\n',
      '{"format":"formicarium/scenario@99"}',
      'good morning',
    ]) {
      await race.paste(text)
      const toast = page.getByTestId('toast-error')
      await expect(toast).toBeVisible()
      await expect(toast.locator('.toast-hint')).not.toBeEmpty()
      await toast.getByRole('button', { name: 'Dismiss' }).click()
      await expect(toast).toHaveCount(0)
    }
    expect(await race.walls()).toBe(walls)
    await page.getByTestId('play').click()
    await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  })

  test('an import can be undone', async ({ page }) => {
    const race = new RacePage(page)
    const before = await race.walls()
    await race.paste(MATRIX)
    await expect.poll(() => race.walls()).toBe(EXPECTED.walls)
    await page.locator('body').press('Control+z')
    await expect.poll(() => race.walls()).toBe(before)
  })
})

async function exported(race: RacePage, format: string): Promise<string> {
  return (await race.exported(format)).bytes.toString('utf8')
}

/** Opens a built-in map; some have to be generated first. */
async function fromGallery(race: RacePage, id: string): Promise<void> {
  const item = race.page.getByTestId(`gallery-${id}`)
  await race.menu('map-menu', `gallery-${id}`)
  await expect(item).toHaveAttribute('aria-checked', 'true')
  await race.ready()
}

test.describe('export', () => {
  test.beforeEach(async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.paste(MATRIX)
    await expect.poll(() => race.walls()).toBe(EXPECTED.walls)
  })

  test('MovingAI map', async ({ page }) => {
    const text = await exported(new RacePage(page), 'movingai-map')
    expect(text.split(/\r?\n/).slice(0, 4)).toEqual(['type octile', 'height 4', 'width 6', 'map'])
    expect(text.split(/\r?\n/)[5]).toMatch(/^\.[@T]{4}\.$/)
  })

  test('MovingAI scenario with the exact optimum', async ({ page }) => {
    const text = await exported(new RacePage(page), 'movingai-scen')
    await new RacePage(page).menu('map-menu', 'open-export')
    const map = await page.getByTestId('export-download').textContent()
    await page.keyboard.press('Escape')
    const fields = text.trim().split('\n')[1]?.split('\t') ?? []
    expect(fields).toHaveLength(9)
    expect(map).toContain(` ${fields[1]}`)
    const optimum = page.getByTestId('optimum')
    await expect(optimum).toHaveAttribute('data-value', /\d/)
    expect(Number(fields[8])).toBeCloseTo(Number(await optimum.getAttribute('data-value')), 6)
  })

  test('0/1 matrix', async ({ page }) => {
    const text = await exported(new RacePage(page), 'matrix')
    expect(text.match(/[01]/g)?.join('')).toBe(MATRIX.match(/[01]/g)?.join(''))
  })

  test('session', async ({ page }) => {
    const race = new RacePage(page)
    const text = await exported(race, 'experiment')
    expect(JSON.parse(text)).toMatchObject({
      format: 'formicarium/experiment@1',
      map: ['......', '.@@@@.', '.@..@.', '...@..'],
    })
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.importByButton('again.json', text)
    await expect.poll(() => race.walls()).toBe(EXPECTED.walls)
  })
})

test.describe('maps made here', () => {
  for (const id of [
    'two-corridors',
    'aco-20x20',
    'engine-room',
    'rooms',
    'maze',
    'random-100',
    'open-field',
  ]) {
    test(`${id} can be solved`, async ({ page }) => {
      const race = new RacePage(page)
      await race.openAtRest()
      await fromGallery(race, id)
      await expect
        .poll(async () => Number(await page.getByTestId('optimum').getAttribute('data-value')))
        .toBeGreaterThan(10)
      await race.setSpeed(8)
      await page.getByTestId('play').click()
      await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    })
  }

  test('unreachable: both planners say that there is no path', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await fromGallery(race, 'unreachable')
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'no-path')
    await expect(page.getByTestId('gap-1')).toContainText(/no path/i)
  })

  test('a generated map is the same for the same seed', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const maps: string[] = []
    for (const seed of ['5', '6', '5']) {
      await race.menu('map-menu', 'open-generate')
      await page.getByTestId('generate-seed').fill(seed)
      await page.getByTestId('generate').click()
      await expect(page.getByTestId('generate-dialog')).toBeHidden()
      await race.ready()
      maps.push((await race.session()).scenario.cells.join(''))
    }
    expect(maps[0]).toBe(maps[2])
    expect(maps[0]).not.toBe(maps[1])
  })
})
