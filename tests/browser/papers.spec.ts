import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test } from '@playwright/test'
import { paperMaps } from '../../www/src/gallery/paper_maps'
import { RacePage } from './race_page'
import { drawn } from './workers'

const ROOT = join(__dirname, '../..')
const CARDS = readdirSync(join(ROOT, 'docs/papers')).filter((name) => name.endsWith('.md'))
const cardText = (file: string) => readFileSync(join(ROOT, 'docs/papers', file), 'utf8')

/** The planners that a card's "Planners:" line names without a preset. */
function plannersOf(text: string): string[] {
  const line = /^Planners?:(.*)$/m.exec(text)?.[1] ?? ''
  return [...line.matchAll(/`([a-z0-9-]+)`/g)].map(([, planner]) => planner ?? '')
}

/** Opens the menu when the catalog is complete. */
async function openAddMenu(page: Page): Promise<void> {
  await page.getByTestId('add-panel').click()
  await expect(page.getByTestId('add-acost')).toBeVisible()
}

test.describe('scenarios of the papers', () => {
  for (const { id, file, racers } of paperMaps) {
    test(`${id} brings its map and the planners that belong to it`, async ({ page }) => {
      const race = new RacePage(page)
      await race.openAtRest()
      await race.menu('map-menu', `gallery-${id}`)
      const { width, height, start, goals } = JSON.parse(
        readFileSync(join(ROOT, 'experiments/maps', `${file}.json`), 'utf8'),
      )
      await expect(page.getByTestId(`gallery-${id}`)).toHaveAttribute('aria-checked', 'true')
      await race.ready()
      const { scenario, panels } = await race.session()
      expect(scenario.spec).toMatchObject({ width, height, start, goals })
      expect(panels.map(({ planner, preset }) => [planner, preset])).toEqual(
        racers.map(([planner, preset]) => [planner, preset ?? null]),
      )
      await page.evaluate(() => window.formicarium.run({ iterations: 1 }))
      for (const { summary } of await race.results()) expect(summary?.iteration).toBeGreaterThan(0)
      // The exact planner ends where the reference says.
      await page.evaluate(() => window.formicarium.run())
      const last = page.getByTestId(`gap-${racers.length}`)
      await expect(last).toHaveAttribute('data-gap', '0')
    })
  }

  test('two panels of one planner are told apart by their presets', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-fire')
    const panel = (place: number) => page.getByTestId(`panel-${place}`)
    await expect(panel(1)).toHaveAccessibleName(/Multi-fire ACO · paper$/)
    await expect(panel(2)).toHaveAccessibleName(/Multi-fire ACO · basic$/)
    await expect(panel(3)).toHaveAccessibleName(/Exact tour$/)
    await page.getByTestId('parameters-2').click()
    await page.getByTestId('preset').selectOption('paper')
    await expect(panel(2)).toHaveAccessibleName(/Multi-fire ACO · same as no. 1$/)
    await page.getByTestId('preset').selectOption('')
    await expect(panel(2)).toHaveAccessibleName(/Multi-fire ACO$/)
  })

  test('the former planners can be brought back, and undo the former map', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-threshold-1')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await page.getByRole('button', { name: 'Bring back the former ones' }).click()
    await expect(page.getByTestId('panel-3')).toBeHidden()
    await race.ready()
    expect((await race.session()).panels.map(({ planner }) => planner)).toEqual([
      'ant-system',
      'astar',
    ])
    await page.keyboard.press('Control+z')
    await expect.poll(async () => (await race.session()).scenario.spec.width).toBe(36)
  })
})

test.describe('results by what they are measured by', () => {
  test('a refined path is compared with the shortest polyline, and its length before is shown', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-ship-20')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await race.ready()
    await page.evaluate(() => window.formicarium.run())
    const [ship, basic, exact] = await race.results()
    expect(ship?.summary?.objective).toBe('polyline-length')
    const [before, length] = [ship?.summary?.unrefined_length, ship?.summary?.metrics?.length]
    expect(before ?? 0).toBeGreaterThanOrEqual(length ?? Number.POSITIVE_INFINITY)
    await page.getByTestId('all-metrics').click()
    await expect(page.getByTestId('metric-unrefinedLength-1')).toHaveText((before ?? 0).toFixed(2))
    await expect(page.getByTestId('metric-unrefinedLength-2')).toHaveText('–')
    const best = exact?.summary?.value ?? 0
    await expect(page.getByTestId('metric-comparedWith-1')).toHaveText(
      `shortest polyline ${best.toFixed(2)}`,
    )
    await expect(page.getByTestId('metric-comparedWith-2')).toContainText('shortest path')
    expect(basic?.summary?.objective).toBe('length')
    await expect(page.getByTestId('gap-1')).toContainText('shortest polyline')
    await expect(page.getByTestId('chart-optimum')).toHaveCount(2)
  })

  test('a smallest turn index is proven best, not shortest', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await openAddMenu(page)
    await page.getByTestId('add-turn-aware').click()
    await race.ready()
    await page.evaluate(() => window.formicarium.run())
    await expect(page.getByTestId('status-3')).toHaveText('Proven best')
    const { summary } = await race.result(3)
    expect(summary?.value).toBe(summary?.metrics?.turn_index)
    await expect(page.getByTestId('readout-value-3')).toHaveText((summary?.value ?? 0).toFixed(2))
    await page.getByTestId('all-metrics').click()
    await expect(page.getByTestId('metric-comparedWith-3')).toContainText('smallest turn index')
    await expect(page.getByTestId('gap-3')).toHaveAttribute('data-gap', '0')
  })

  test('the layers of all planners are offered, each with what it means', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-paper-criss-cross')
    await expect(page.getByTestId('panel-3')).toBeVisible()
    await race.ready()
    const picker = page.getByTestId('layer')
    const offered = await picker
      .locator('option')
      .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value))
    expect(offered).toEqual(expect.arrayContaining(['trail', 'initial-trail', 'seed-path', 'none']))
    await page.evaluate(() => window.formicarium.run({ iterations: 60 }))
    for (const id of offered.filter((value) => value !== 'none')) {
      await picker.selectOption(id)
      await expect(picker).toHaveAttribute('title', /\w{4}/)
      await expect(picker.locator(`option[value="${id}"]`)).toHaveAttribute('title', /\w{4}/)
    }
    await picker.selectOption('trail')
    await drawn(page)
    await race.seesMotion(1, () => picker.selectOption('seed-path'))
  })
})

test.describe('paper cards', () => {
  test('nobody who does not read them fetches them', async ({ page }) => {
    const asked: string[] = []
    page.on('request', (request) => asked.push(request.url()))
    const race = new RacePage(page)
    await race.open()
    await openAddMenu(page)
    expect(asked.filter((url) => /markdown|docs\/papers/.test(url))).toEqual([])
  })

  for (const file of CARDS) {
    test(`${file} is shown as it is`, async ({ page }) => {
      const text = cardText(file)
      const [planner] = plannersOf(text)
      const race = new RacePage(page)
      await race.openAtRest()
      await openAddMenu(page)
      await page.getByTestId(`about-${planner}`).click()
      const dialog = page.getByTestId('card-dialog')
      const headings = [...text.matchAll(/^#+ (.*)$/gm)].map(([, words]) => words ?? '')
      await expect(dialog.getByRole('heading').first()).toHaveText(plain(headings[0] ?? ''))
      await expect
        .poll(() => dialog.locator('.card').getByRole('heading').allTextContents())
        .toEqual(headings.slice(1).map(plain))
      const tables = text.match(/^\|[-:| ]+\|$/gm)?.length ?? 0
      await expect(dialog.locator('table')).toHaveCount(tables)
      // Every word of the first table's rows, in its place.
      const cell = /^\| ([^|]+) \|/m.exec(text.slice(text.indexOf('\n|---')))?.[1] ?? ''
      await expect(dialog.locator('tbody td').first()).toHaveText(plain(cell))
      for (const link of await dialog.locator('a').all()) {
        expect(await link.getAttribute('href')).toMatch(/^https?:/)
        expect(await link.getAttribute('rel')).toContain('noopener')
      }
      await page.keyboard.press('Escape')
      await expect(dialog).toBeHidden()
    })
  }

  test.describe('on a Chinese page', () => {
    test.use({ locale: 'zh-CN' })

    test('a card is told in Chinese, and in English to who changes the language', async ({
      page,
    }) => {
      await new RacePage(page).open()
      await openAddMenu(page)
      await page.getByTestId('about-acost').click()
      const dialog = page.getByTestId('card-dialog')
      await expect(dialog.getByRole('heading').first()).toHaveText('ACOST：阈值自适应的蚁群')
      await expect(dialog.locator('.card')).toHaveAttribute('lang', 'zh-CN')
      await expect(dialog.locator('tbody').first()).toContainText('找到路径的运行比例')
      await expect(dialog.locator('tbody').nth(1)).toContainText('随机比例规则')
      await page.keyboard.press('Escape')
      await page.getByTestId('language').click()
      await page.getByTestId('language-en').click()
      await openAddMenu(page)
      await page.getByTestId('about-acost').click()
      await expect(dialog.locator('.card')).toHaveAttribute('lang', 'en')
      await expect(dialog.getByRole('heading').first()).toHaveText(/^ACOST: ant colony/)
    })
  })

  test('a panel leads to the card of its planner, or of its preset', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await page.getByTestId('parameters-1').click()
    await expect(page.getByTestId('about-planner')).toBeHidden()
    await page.getByTestId('preset').selectOption('ship')
    await page.getByTestId('about-planner').click()
    await expect(page.getByTestId('card-dialog')).toContainText('Engine-room')
  })

  for (const scheme of ['light', 'dark'] as const) {
    test(`axe finds nothing serious in a card (${scheme})`, async ({ page }) => {
      await page.emulateMedia({ colorScheme: scheme })
      await new RacePage(page).openAtRest()
      await openAddMenu(page)
      await page.getByTestId('about-acost').click()
      await expect(page.getByTestId('card-dialog').locator('table').first()).toBeVisible()
      const { violations } = await new AxeBuilder({ page }).analyze()
      expect(violations.filter(({ impact }) => impact === 'serious').map(({ id }) => id)).toEqual(
        [],
      )
    })
  }

  test('on a phone a card is read without moving the page sideways @phone', async ({ page }) => {
    await new RacePage(page).openAtRest()
    await openAddMenu(page)
    await page.getByTestId('about-acost').click()
    const dialog = page.getByTestId('card-dialog')
    await expect(dialog.locator('table').first()).toBeVisible()
    const sideways = await dialog
      .locator('.dialog-content')
      .evaluate((content) => content.scrollWidth - content.clientWidth)
    expect(sideways).toBeLessThanOrEqual(0)
  })
})

/** Markdown without its marks. */
function plain(text: string): string {
  return text
    .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
    .replace(/[`*]/g, '')
    .replace(/\\(.)/g, '$1')
    .trim()
}
