/** Names that readers give, notes, and what a link looked at. */
import { readFile } from 'node:fs/promises'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { ComparisonPage } from './comparison_page'
import { freshRace, RacePage } from './race_page'

const label = (page: Page, place: number) => page.getByTestId(`label-${place}`)
const field = (page: Page, place: number) => page.getByTestId(`label-field-${place}`)
const undo = (page: Page) => page.keyboard.press('Control+z')

async function rename(page: Page, place: number, name: string): Promise<void> {
  await label(page, place).press('F2')
  await field(page, place).fill(name)
  await field(page, place).press('Enter')
  await expect(field(page, place)).toBeHidden()
}

/** Writes into the dialog of names. */
async function caption(race: RacePage, words: Partial<Record<'title' | 'note' | 'map', string>>) {
  const { page } = race
  await race.menu('map-menu', 'open-names')
  if (words.title !== undefined) await page.getByTestId('session-title').fill(words.title)
  if (words.note !== undefined) await page.getByTestId('session-note').fill(words.note)
  if (words.map !== undefined) await page.getByTestId('map-name-field').fill(words.map)
  await page.getByTestId('names-done').click()
  await expect(page.locator('dialog')).toHaveCount(0)
}

async function setParam(page: Page, place: number, key: string, value: string): Promise<void> {
  await page.getByTestId(`parameters-${place}`).click()
  const field = await new RacePage(page).param(key)
  await field.fill(value)
  await field.press('Enter')
}

test.describe('the name of a planner', () => {
  test('is changed by keyboard, in place, and undone', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const head = page.getByTestId('panel-1').locator('.panel-head')
    const before = await head.boundingBox()
    const moves = await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    await label(page, 1).focus()
    await page.keyboard.press('Enter')
    await expect(field(page, 1)).toBeFocused()
    expect((await head.boundingBox())?.height).toBe(before?.height)
    await page.keyboard.type('  Slow ants ')
    await page.keyboard.press('Enter')
    await expect(label(page, 1)).toHaveText('Slow ants')
    await expect(label(page, 1)).toBeFocused()
    await expect(page.getByTestId('panel-1')).toHaveAccessibleName('Panel 1: Slow ants')
    // A name is no reason to begin again.
    expect((await race.result(1)).summary?.digest).toBe(moves[0]?.summary?.digest)

    await page.keyboard.press('F2')
    await page.keyboard.type('Something else')
    await page.keyboard.press('Escape')
    await expect(label(page, 1)).toHaveText('Slow ants')

    await undo(page)
    await expect(label(page, 1)).toHaveText('Ant System')
    await page.keyboard.press('Control+Shift+z')
    await expect(label(page, 1)).toHaveText('Slow ants')
    await rename(page, 1, '')
    await expect(label(page, 1)).toHaveText('Ant System')
    await label(page, 1).dblclick()
    await expect(field(page, 1)).toBeFocused()
    await field(page, 1).fill('x'.repeat(80))
    await page.getByTestId('seed').click()
    await expect(label(page, 1)).toHaveText('x'.repeat(60))
  })

  test('otherwise says what differs, everywhere alike', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('add-panel', 'add-ant-system')
    await race.ready()
    await expect(label(page, 1)).toHaveText('Ant System')
    await expect(label(page, 3)).toHaveText('Ant System · same as no. 1')
    await setParam(page, 3, 'rho', '0.05')
    await expect(label(page, 1)).toHaveText('Ant System · ρ 0.5')
    await expect(label(page, 3)).toHaveText('Ant System · ρ 0.05')
    for (const key of ['ants', 'beta']) await setParam(page, 3, key, '7')
    await expect(label(page, 3)).toHaveText('Ant System · m 7, β 7, …')
    await expect(label(page, 1)).toHaveText('Ant System · m 50, β 5, …')
    // Where two are not told apart by so few, all are said.
    await race.menu('add-panel', 'add-ant-system')
    for (const key of ['ants', 'beta']) await setParam(page, 4, key, '7')
    await expect(label(page, 4)).toHaveText('Ant System · m 7, β 7, ρ 0.5')
    await expect(label(page, 3)).toHaveText('Ant System · m 7, β 7, ρ 0.05')
    await page.getByTestId('preset').selectOption('fire')
    await expect(label(page, 4)).toHaveText('Ant System · fire')
    await rename(page, 2, 'The exact one')

    const names = ['Ant System · m 50, β 5, …', 'The exact one', 'Ant System · m 7, β 7, …']
    for (const name of names) {
      await expect(page.locator('.convergence li').filter({ hasText: name })).toBeVisible()
      const row = page.locator('.comparison').getByRole('rowheader', { name })
      await expect(row.first()).toBeVisible()
    }
    await page.getByTestId('share').click()
    for (const name of names)
      await expect(page.locator('.share-contents li').filter({ hasText: name })).toHaveCount(1)
    await race.leaveDialog()
  })

  test('is changed by one tap on a phone, where nothing moves @phone', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const stage = () => race.stage().boundingBox()
    const before = await stage()
    await label(page, 1).tap()
    await expect(field(page, 1)).toBeFocused()
    expect(await stage()).toEqual(before)
    expect((await field(page, 1).boundingBox())?.height).toBeGreaterThanOrEqual(40)
    await field(page, 1).fill('Slow')
    await field(page, 1).press('Enter')
    await expect(label(page, 1)).toHaveText('Slow')
    expect(await stage()).toEqual(before)
  })
})

test.describe('title, note and the name of the map', () => {
  test('are typed, shown, kept through a reload, and undone step by step', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await expect(page.getByTestId('note-strip')).toBeHidden()
    const note = 'First line\n<img src=x onerror="window.broken = true">\n\nlast'
    await caption(race, { title: 'Why evaporation matters', note, map: 'My corridors' })
    await expect(page).toHaveTitle('Why evaporation matters – Formicarium')
    const strip = page.getByTestId('note-strip')
    await expect(strip).toContainText('Why evaporation matters')
    await expect(strip).toContainText('First line')
    await expect(page.getByTestId('map-menu')).toContainText('My corridors')
    await page.getByTestId('note-read').focus()
    await page.keyboard.press('Enter')
    await expect(page.getByTestId('note-text')).toBeVisible()
    expect(await page.getByTestId('note-text').innerText()).toBe(note)
    expect(await page.evaluate(() => 'broken' in window)).toBe(false)
    await expectClean(page, 'note')
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('note-text')).toBeHidden()

    await rename(page, 1, 'Slow ants')
    const kept = () => page.evaluate(() => sessionStorage.getItem('formicarium.session'))
    const before = await kept()
    await page.getByTestId('seed').fill('5')
    await page.getByTestId('seed').press('Enter')
    await expect.poll(kept).not.toBe(before)
    await page.reload()
    await race.ready()
    await expect(label(page, 1)).toHaveText('Slow ants')
    await expect(strip).toContainText('Why evaporation matters')
    expect((await race.session()).note).toBe(note)
    await expect(page.getByTestId('announcement')).toContainText('Why evaporation matters')

    await caption(race, { title: 'Another' })
    await caption(race, { note: '' })
    await caption(race, { map: 'Still mine' })
    await undo(page)
    await expect(page.getByTestId('map-menu')).toContainText('My corridors')
    await undo(page)
    expect((await race.session()).note).toBe(note)
    await undo(page)
    await expect(strip).toContainText('Why evaporation matters')
    await page.getByTestId('note-close').click()
    await expect(strip).toBeHidden()
  })

  test('a map cannot be without a name', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'open-names')
    await page.getByTestId('map-name-field').fill('  ')
    await expect(page.getByTestId('map-name-field')).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByTestId('names-dialog')).toContainText('A map needs a name')
    await expectClean(page, 'names')
    await race.leaveDialog()
    await expect(page.getByTestId('map-menu')).toContainText('Two corridors')
    await expect(page.getByTestId('undo')).toBeDisabled()
  })

  test('go with a session that is opened, and come back by undo', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await caption(race, { title: 'Mine' })
    await page.evaluate(async () => {
      const session = window.formicarium.session()
      if (session) await window.formicarium.load({ ...session, title: 'Theirs', note: 'n' })
    })
    await expect(page.getByTestId('note-strip')).toContainText('Theirs')
    await undo(page)
    await expect(page.getByTestId('note-strip')).toContainText('Mine')
    await race.menu('map-menu', 'start-over')
    await expect(page.getByTestId('note-strip')).toBeHidden()
    await expect(page).toHaveTitle(/^Formicarium/)
  })

  test('in Chinese a built-in map has its translated name until it is renamed', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('map-menu', 'gallery-aco-20x20')
    await race.menu('language', 'language-zh-CN')
    await race.menu('add-panel', 'add-ant-system')
    await race.drag([[10, 3]])
    const menu = page.getByTestId('map-menu')
    await expect(menu).toContainText('20 × 20')
    await expect(menu).not.toContainText(/[a-z]/)
    await page.getByTestId('share').click()
    const lines = page.locator('.share-contents li')
    await expect(lines.first()).toHaveText(/^地图“[^a-zA-Z]*20 × 20”$/)
    const rows = await lines.allInnerTexts()
    expect(new Set(rows.map((row) => row.split(' · 尚无')[0])).size).toBe(rows.length)
    await page.getByTestId('share-names').click()
    await page.getByTestId('map-name-field').fill('我的地图')
    await expect(lines.first()).toHaveText('地图“我的地图”，20 × 20')
    await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
    const link = await page.getByTestId('share-link').inputValue()
    await race.leaveDialog()
    await expect(menu).toContainText('我的地图')
    await undo(page)
    await expect(menu).not.toContainText('我的地图')
    const other = await freshRace(browser, link)
    expect((await other.session()).scenario.spec.name).toBe('我的地图')
    await other.page.context().close()
  })
})

test.describe('a link', () => {
  test('shows title, note, labels, the iteration and the cell that were looked at', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.menu('add-panel', 'add-ant-system')
    await setParam(page, 3, 'rho', '0.05')
    await rename(page, 3, 'Slow ants')
    await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
    await page.evaluate(() => window.formicarium.look(4))
    await page.locator('body').press('i')
    const { start } = (await race.session()).scenario.spec
    const at = await race.pointOf(start, 3)
    await page.mouse.click(at.x, at.y)
    await expect(page.getByTestId('moves')).toBeVisible()
    const moves = await page.getByTestId('moves').innerText()
    await page.getByTestId('share').click()
    await expect(page.locator('.share-contents')).toContainText('Looks back at iteration 4')
    await expect(page.locator('.share-contents')).toContainText('of Slow ants')
    await page.getByTestId('share-names').click()
    const link = page.getByTestId('share-link')
    await expect(link).toHaveValue(/#x=/)
    const bare = await link.inputValue()
    await page.getByTestId('session-title').fill('Why evaporation matters')
    await page.getByTestId('session-note').fill('Look at the corridor.')
    await expect(link).toHaveValue(/#x=/)
    expect(await link.inputValue()).not.toBe(bare)
    const words = { title: 'Why evaporation matters', note: 'Look at the corridor.' }

    const other = await freshRace(browser, await link.inputValue())
    await expect(other.page.getByTestId('note-strip')).toContainText(words.title)
    await expect(other.page.getByTestId('note-strip')).toContainText(words.note)
    await expect(label(other.page, 3)).toHaveText('Slow ants')
    const looked = { look: 4, inspected: { panel: 2, cell: start, level: null } }
    expect(await other.session()).toMatchObject({ ...words, ...looked })
    await other.page.getByRole('button', { name: 'Run there now' }).click()
    await expect(other.page.getByTestId('looking-back')).toContainText('Iteration 4 of')
    await expect(other.page.getByTestId('moves-card')).toContainText('Slow ants, after iteration 4')
    expect(await other.page.getByTestId('moves').innerText()).toBe(moves)
    await expect(other.page.getByTestId('verified-3')).toHaveAttribute('data-verified', 'verified')
    expect(await other.session()).toMatchObject({ ...words, ...looked })
    await other.page.context().close()
  })

  test('says why what was looked at is not to be seen', async ({ page, browser }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await setParam(page, 1, 'iterations', '5')
    const load = (look: number) =>
      page.evaluate(async (iteration) => {
        const session = window.formicarium.session()
        if (session) await window.formicarium.load({ ...session, look: iteration })
      }, look)
    const toast = page.getByTestId('toast-warning')
    await load(9)
    await page.getByTestId('run-to-end').click()
    await expect(toast).toContainText('ended at iteration 5; iteration 9')
    await load(3)
    await page.getByTestId('seed').fill('8')
    await page.getByTestId('seed').press('Enter')
    await expect(toast.filter({ hasText: 'another one now' })).toBeVisible()
    expect((await race.session()).look).toBeNull()

    // A planner of tomorrow leaves its panel out.
    const session = await race.session()
    const other = await freshRace(browser, './')
    await other.page.evaluate(
      async ([panel, cell]) => {
        const now = window.formicarium.session()
        if (!now || !panel || !cell) throw new Error('no session')
        const stranger = { ...panel, planner: 'of-tomorrow' }
        const inspected = { panel: 2, cell, level: null }
        await window.formicarium.load({ ...now, panels: [...now.panels, stranger], inspected })
      },
      [session.panels[0], session.scenario.spec.start] as const,
    )
    await expect(
      other.page.getByTestId('toast-warning').filter({ hasText: 'a planner that is not here' }),
    ).toBeVisible()
    await other.page.context().close()
  })

  test('of a script stops nothing: it says itself how far it runs', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const link = await page.evaluate(async () => {
      await window.formicarium.run({ iterations: 5 })
      await window.formicarium.look(2)
      return window.formicarium.session()?.look
    })
    expect(link).toBe(2)
    const text = await race.shareLink()
    const reached = await page.evaluate(async (source) => {
      await window.formicarium.load(source)
      const [ants] = await window.formicarium.run({ iterations: 4 })
      return ants?.summary?.iteration
    }, text)
    expect(reached).toBe(4)
    await expect(page.getByTestId('looking-back')).toBeHidden()
    const refused = await page.evaluate(async () => {
      const session = window.formicarium.session()
      if (!session) return null
      return window.formicarium.load({ ...session, title: 'a\nb' }).then(
        () => null,
        ({ kind, field, message, hint }) => ({ kind, field, message, hint }),
      )
    })
    expect(refused).toMatchObject({ kind: 'link-invalid', field: 'title' })
  })
})

test('a file carries names, note and look, and is dropped on the page', async ({
  page,
  browser,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await rename(page, 2, 'The exact one')
  await caption(race, { title: 'Filed', note: 'a\nb' })
  await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
  await page.evaluate(() => window.formicarium.look(1))
  await page.getByTestId('share').click()
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId('share-file').click(),
  ])
  const text = await readFile(await download.path(), 'utf8')
  expect(JSON.parse(text)).toMatchObject({ title: 'Filed', note: 'a\nb', look: 1 })
  const other = await freshRace(browser, './')
  await other.drop('race.experiment.json', text)
  await expect(other.page.getByTestId('note-strip')).toContainText('Filed')
  await expect(label(other.page, 2)).toHaveText('The exact one')
  expect(await other.session()).toMatchObject({ title: 'Filed', note: 'a\nb', look: 1 })
  await other.page.context().close()
})

test('names and note go to Compare, and into its document', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('add-panel', 'add-ant-system')
  await setParam(page, 3, 'rho', '0.05')
  await rename(page, 2, 'The exact one')
  await caption(race, { title: 'Does it matter?', note: 'Little evaporation\nagainst much.' })
  await page.getByTestId('view-lab').click()
  const comparison = new ComparisonPage(page)
  await comparison.ready()
  await expect(page.getByTestId('study-title')).toHaveValue('Does it matter?')
  await expect(page.getByTestId('study-note')).toHaveValue('Little evaporation\nagainst much.')
  await comparison.seeds(1)
  await comparison.run()
  await comparison.finished()
  const text = await page.evaluate(() => window.formicarium.resultFile('json'))
  const link = await page.evaluate(() => window.formicarium.resultFile('link'))
  const { question } = JSON.parse(link)
  expect([question.title, question.asks]).toEqual([
    'Does it matter?',
    'Little evaporation\nagainst much.',
  ])
  const labels = ['Ant System · ρ 0.5', 'The exact one', 'Ant System · ρ 0.05']
  expect(question.entries.map((entry: { label: string }) => entry.label)).toEqual(labels)
  for (const name of labels) expect(text).toContain(name)
})
