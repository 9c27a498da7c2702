/** The gallery of lessons: each opens at rest with its question, runs to the recorded digests, and says what happened when asked. */
import { readdirSync, readFileSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { enLessons } from '../../www/src/i18n/en/lessons'
import { zhCNLessons } from '../../www/src/i18n/zh_cn/lessons'
import { expectClean } from './axe'
import { dropFiles } from './dropped_files'
import { RacePage } from './race_page'

const FOLDER = join(__dirname, '../../www/lessons')
const ENDING = '.experiment.json'
const IDS = readdirSync(FOLDER)
  .filter((file) => file.endsWith(ENDING))
  .map((file) => file.slice(0, -ENDING.length))

interface Recorded {
  iterations: number
  status: string
  length: number | null
  digest: string
}
const recorded = (id: string): Recorded[] =>
  JSON.parse(readFileSync(join(FOLDER, id + ENDING), 'utf8')).panels.map(
    ({ result }: { result: Recorded }) => result,
  )

async function openLesson(page: Page, id: string): Promise<RacePage> {
  const race = new RacePage(page)
  await race.open(`./#lesson=${id}`)
  await expect(page.getByTestId('guide')).toBeVisible()
  return race
}

const answer = (page: Page) => page.getByTestId('guide-answer')

test.describe('lesson', () => {
  for (const id of IDS)
    test(`${id} opens at rest, and runs to the digests of the command line`, async ({ page }) => {
      const race = await openLesson(page, id)
      const { title, question } = enLessons.each[id as keyof typeof enLessons.each]
      await expect(page.getByTestId('guide').getByRole('heading')).toHaveText(title)
      await expect(page.getByTestId('guide')).toContainText(question)
      await expect(answer(page)).not.toHaveAttribute('open')
      await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
      expect(await race.antMoves()).toBe(0)

      await page.evaluate(() => window.formicarium.run({ stops: 'ignore' }))
      const reached = (await race.results()).map(({ summary }) => ({
        iterations: summary?.iteration,
        status: summary?.status,
        length: summary?.metrics?.length ?? null,
        digest: summary?.digest,
      }))
      expect(reached).toEqual(recorded(id))

      await answer(page).locator('summary').click()
      await expect(answer(page)).toContainText('100')
      await expect(page.getByTestId('guide')).not.toContainText(/\{\{|undefined/)
    })

  test('the planner of the dead end stays in it', async ({ page }) => {
    const race = await openLesson(page, 'dead-end')
    await page.evaluate(() => window.formicarium.run({ stops: 'ignore' }))
    const [trapped, ...others] = await race.results()
    expect(trapped?.history.every(([, best]) => Number.isNaN(best))).toBe(true)
    expect(trapped?.path).toBeNull()
    for (const { path } of others) expect(path?.at(-1)).toEqual([25, 8])
  })

  test('a stop of the lesson holds its race', async ({ page }) => {
    const race = await openLesson(page, 'bridge')
    await race.setSpeed(8)
    await page.getByTestId('play').click()
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'paused')
    expect((await race.result(1)).summary?.iteration).toBe(10)
  })

  test('the path by hand of the corners is refused by name', async ({ page }) => {
    await openLesson(page, 'corners')
    await page.getByTestId('lesson-menu').click()
    await page.getByTestId('lesson-draw').click()
    await expect(page.getByText('No path on this map.')).toContainText('(9, 6)')
    // The card of the lesson comes back after it.
    await page.keyboard.press('Escape')
    await expect(page.getByTestId('guide')).toBeVisible()
  })
})

test.describe('the gallery', () => {
  test('shows ten lessons with their maps, and opens one by keyboard', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await race.menu('map-menu', 'open-lessons')
    const dialog = page.getByTestId('lessons-dialog')
    await expect(dialog.locator('canvas')).toHaveCount(10)
    await expectClean(page, 'the gallery of lessons')
    await page.getByTestId('lesson-terrain').focus()
    await page.keyboard.press('Enter')
    await expect(dialog).toBeHidden()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.terrain.question)
    expect(new URL(page.url()).hash).toBe('#lesson=terrain')
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
    await expectClean(page, 'a lesson')
    await race.menu('map-menu', 'open-lessons')
    await expect(page.getByTestId('lesson-terrain')).toHaveAttribute('aria-current', 'true')
  })

  test('leads from one lesson to the next, until the last', async ({ page }) => {
    await openLesson(page, 'paper-claim')
    await answer(page).locator('summary').click()
    await page.getByTestId('guide-next').click()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each['robot-map'].title)
    await expect(answer(page)).not.toHaveAttribute('open')
    await expect(page.getByTestId('guide-next')).toBeHidden()
    await page.getByTestId('guide-all').click()
    await expect(page.getByTestId('lessons-dialog')).toBeVisible()
  })

  test('copies a link that opens the lesson, from anywhere', async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    const race = new RacePage(page)
    await race.open()
    await race.menu('map-menu', 'open-lessons')
    await page.getByTestId('lesson-link-goals').click()
    const link = await page.evaluate(() => navigator.clipboard.readText())
    expect(link).toMatch(/#lesson=goals$/)
    await race.open(link)
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.goals.title)
    // A text with such a link opens it as well.
    await race.paste('Look: https://example.org/#lesson=bridge')
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.bridge.title)
  })

  test('saves a file that opens as the same race, with title, note and question', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.open()
    await race.menu('map-menu', 'open-lessons')
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId('lesson-file-stagnation').click(),
    ])
    expect(download.suggestedFilename()).toBe('stagnation.experiment.json')
    const text = await readFile(await download.path(), 'utf8')
    await page.keyboard.press('Escape')
    await dropFiles(page, 'body', [['mine.experiment.json', text]])
    const { title, question } = enLessons.each.stagnation
    await expect(page.getByTestId('note-strip')).toContainText(title)
    const session = await race.session()
    expect(session.note).toContain(question)
    expect(session.panels.map(({ label }) => label)).toEqual(['Ant System', 'Between limits'])
    for (const place of [1, 2])
      await expect(page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
  })
})

test.describe('the address of a lesson', () => {
  test('brings it back after a reload, until it is closed', async ({ page }) => {
    const race = await openLesson(page, 'evaporation')
    await page.reload()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.evaporation.title)
    await page.getByTestId('guide-close').click()
    await expect(page.getByTestId('guide')).toBeHidden()
    expect(new URL(page.url()).hash).toBe('')
    // The race stays, and is called as the lesson.
    await expect(page.getByTestId('note-strip')).toContainText(enLessons.each.evaporation.title)
    expect((await race.session()).panels.map(({ params }) => params.rho)).toEqual([0.01, 1])
  })

  test('is left with the lesson: another map has no card of it', async ({ page }) => {
    const race = await openLesson(page, 'bridge')
    await race.menu('map-menu', 'gallery-open-field')
    await expect(page.getByTestId('guide')).toBeHidden()
    expect(new URL(page.url()).hash).toBe('')
  })

  test('comes back with Back and Forward', async ({ page }) => {
    await openLesson(page, 'bridge')
    await page.evaluate(() => {
      location.hash = '#lesson=corners'
    })
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.corners.title)
    await page.goBack()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.bridge.title)
    await page.goForward()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each.corners.title)
    await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
  })

  test('that names none is told, and the page opens as ever', async ({ page }) => {
    const race = new RacePage(page)
    await race.open('./#lesson=astrology')
    await expect(page.locator('.toasts')).toContainText('There is no lesson “astrology”.')
    await expect(page.getByTestId('guide')).toBeHidden()
    expect((await race.session()).scenario.spec.name).toBe('Two corridors')
  })

  test('is a source for scripts', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await page.evaluate(() => window.formicarium.load('#lesson=alpha-beta'))
    expect((await race.session()).panels).toHaveLength(3)
    const refused = await page.evaluate(() =>
      window.formicarium.load('#lesson=none').catch(({ kind }) => kind),
    )
    expect(refused).toBe('unknown-lesson')
  })
})

test.describe('on a Chinese page', () => {
  test.use({ locale: 'zh-CN' })

  test('lessons speak Chinese, and change with the language', async ({ page }) => {
    await openLesson(page, 'dead-end')
    const { title, question } = zhCNLessons.each['dead-end']
    await expect(page.getByTestId('guide')).toContainText(title)
    await expect(page.getByTestId('guide')).toContainText(question)
    await expect(page).toHaveTitle(new RegExp(title))
    await expect(page.getByTestId('panel-1')).toContainText('蚂蚁死去')
    await page.getByTestId('guide-all').click()
    await expect(page.getByTestId('lesson-goals')).toContainText(zhCNLessons.each.goals.title)
    await page.keyboard.press('Escape')
    await page.getByTestId('language').click()
    await page.getByTestId('language-en').click()
    await expect(page.getByTestId('guide')).toContainText(enLessons.each['dead-end'].question)
  })
})

test('on a phone the card lies below the maps and moves nothing @phone', async ({ page }) => {
  const race = await openLesson(page, 'stagnation')
  await expectClean(page, 'a lesson on a phone')
  const before = await race.box()
  await answer(page).locator('summary').click()
  await page.getByTestId('guide').getByText('formicarium compare').scrollIntoViewIfNeeded()
  expect(await race.box()).toEqual(before)
  await page.getByTestId('card-fold').click()
  await expect(answer(page)).toBeHidden()
  await expect(page.getByTestId('guide')).toContainText(enLessons.each.stagnation.question)
})
