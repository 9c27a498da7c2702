/** Steps of a race as SVG, and the codes of its link: in the share dialog, on steps, in pictures. */
import { readFile } from 'node:fs/promises'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { FilmPage, type Saved, shownAlone } from './film_page'
import { drawnPixels, textOfCode } from './qr_reader'
import { RacePage } from './race_page'
import { sessionOf } from './units/sessions'

async function made(page: Page, what: 'steps' | 'slides', count: number, ofFirst = false) {
  const film = await FilmPage.open(page)
  await page.getByTestId(`film-${what}`).click()
  if (ofFirst) {
    await page.getByTestId('film-panels').selectOption({ index: 1 })
    await page.getByTestId('film-spread').selectOption('better')
  }
  await film.fill({ count })
  await expect(await film.make()).toHaveAttribute('data-agreement', 'same')
  const saved = await film.save()
  await film.race.leaveDialog()
  return { film, saved }
}

/** What a parser of XML finds. */
function parsed(page: Page, { bytes }: Saved) {
  return page.evaluate((source) => {
    const svg = new DOMParser().parseFromString(source, 'image/svg+xml')
    const foreign = [...svg.querySelectorAll('[href]')]
      .map((one) => one.getAttribute('href') ?? '')
      .filter((href) => !/^(data:image\/png|#)/.test(href))
    return {
      fault: svg.querySelector('parsererror')?.textContent ?? null,
      steps: svg.querySelectorAll('.step').length,
      ids: [...svg.querySelectorAll('[id]')].map(({ id }) => id),
      moving: [...(svg.querySelector('style')?.textContent ?? '').matchAll(/@keyframes/g)].length,
      scripts: svg.querySelectorAll('script, foreignObject, [onload]').length,
      foreign: [...new Set(foreign)],
      texts: [...svg.querySelectorAll('text')].map((text) => text.textContent ?? ''),
    }
  }, bytes.toString())
}

/** Pictures of what an SVG file shows as a picture, one after the other, over more than its first steps. */
async function looks(page: Page): Promise<string[]> {
  const all: string[] = []
  for (let time = 0; time < 5; time++) {
    all.push((await page.locator('img').screenshot()).toString('base64'))
    await page.waitForTimeout(700)
  }
  return [...new Set(all)]
}

test('a moving picture has its steps in one file that stands alone, and moves as a picture', async ({
  page,
}) => {
  const { film, saved } = await made(page, 'steps', 5)
  const link = await film.race.shareLink()
  const found = await parsed(page, saved)
  expect(found).toMatchObject({ fault: null, steps: 5, moving: 4, scripts: 0, foreign: [link] })
  expect(new Set(found.ids).size).toBe(found.ids.length)
  for (const at of [0, 3, 6, 9, 12])
    expect(found.texts.some((text) => text.startsWith(`Iteration ${at} ·`))).toBe(true)
  const length = (await film.race.result(1)).summary?.metrics?.length.toFixed(2) ?? '?'
  expect(found.texts.some((text) => text.includes(length) && text.includes('%'))).toBe(true)

  const alone = await shownAlone(page, saved, 'image/svg+xml', 'img')
  expect((await looks(alone)).length).toBeGreaterThan(1)
  expect(textOfCode(await drawnPixels(alone, 'img', 2))).toBe(link)
})

test('where less motion is wanted the last step stands still', async ({ page, browser }) => {
  const { saved } = await made(page, 'steps', 4)
  const shot = async (reducedMotion: 'reduce' | 'no-preference') => {
    const other = await (await browser.newContext({ reducedMotion })).newPage()
    await other.goto(`data:image/svg+xml;base64,${saved.bytes.toString('base64')}`)
    const moving = await other.evaluate(() => document.getAnimations().length)
    const last = other.locator('#step-4')
    return {
      moving,
      isLast: (await last.evaluate((one) => getComputedStyle(one).visibility)) === 'visible',
    }
  }
  expect(await shot('no-preference')).toEqual({ moving: 3, isLast: false })
  expect(await shot('reduce')).toEqual({ moving: 0, isLast: true })
})

test('steps show where better paths were found', async ({ page }) => {
  const { film, saved } = await made(page, 'steps', 24, true)
  const found = await parsed(page, saved)
  const shown = found.texts.flatMap((text) => /^Iteration (\d+)/.exec(text)?.[1] ?? []).map(Number)
  expect(shown).toContain((await film.race.result(1)).summary?.iteration_of_best)
  expect(shown.at(-1)).toBe(12)
  const lengths = found.texts.flatMap((text) => /^Iteration \d+ · ([\d.]+)/.exec(text)?.[1] ?? [])
  // The last one may show what the one before does.
  expect(new Set(lengths).size).toBeGreaterThanOrEqual(lengths.length - 1)
})

test('slides are one file each, and the same whenever they are made', async ({ page }) => {
  const { film, saved } = await made(page, 'slides', 4)
  expect(saved.name).toBe('two-corridors-slides.zip')
  const names = [...saved.bytes.toString('latin1').matchAll(/two-corridors-slides-\d\d\.svg/g)]
  // Each once before its file and once in the list of files.
  expect(new Set(names.map(([name]) => name)).size).toBe(4)
  await film.openDialog()
  await page.getByTestId('film-slides').click()
  await film.fill({ count: 4 })
  await film.make()
  expect((await film.save()).bytes.equals(saved.bytes)).toBe(true)
})

test('the share dialog shows the link as a code, small, on the whole screen and as a file', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  await race.press('share')
  await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
  const link = await page.getByTestId('share-link').inputValue()
  const summary = page.getByTestId('link-code')
  await summary.focus()
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('link-code-large')).toBeVisible()
  await expectClean(page, 'share dialog with code')
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    race.press('link-code-save'),
  ])
  const saved = { name: download.suggestedFilename(), bytes: await readFile(await download.path()) }
  expect(saved.name).toBe('two-corridors-qr.svg')
  const alone = await shownAlone(page, saved, 'image/svg+xml', 'img')
  expect(textOfCode(await drawnPixels(alone, 'img'))).toBe(link)
  await page.getByTestId('link-code-large').focus()
  await page.keyboard.press('Enter')
  const screen = page.getByTestId('link-code-screen')
  await expect(screen).toBeVisible()
  await expectClean(page, 'the code on the whole screen')
  await page.keyboard.press('Escape')
  await expect(screen).toHaveCount(0)
  await expect(page.getByTestId('share-dialog')).toBeVisible()
})

test('a link that no code holds says so', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  const { cells } = sessionOf(128, 128).scenario
  await page.evaluate((walls) => {
    const session = window.formicarium.session()
    if (!session) return
    const { scenario } = session
    scenario.spec = { ...scenario.spec, width: 128, height: 128, start: [0, 0] }
    scenario.spec.goals = scenario.spec.goals.map((goal) => ({ ...goal, at: [127, 127] }))
    scenario.cells = Uint8Array.from(walls)
    scenario.cells[0] = 0
    scenario.cells[128 * 128 - 1] = 0
    return window.formicarium.load(session)
  }, Array.from(cells))
  await race.press('share')
  await expect(page.getByTestId('share-link')).toHaveValue(/#x=/)
  expect((await page.getByTestId('share-link').inputValue()).length).toBeGreaterThan(2953)
  await race.press('link-code')
  await expect(page.getByTestId('link-code-too-long')).toContainText('2,953')
})

test('a picture has the code in its corner where it is wanted', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await page.evaluate(() => window.formicarium.run({ iterations: 5 }))
  const link = await race.shareLink()
  await race.menu('map-menu', 'open-export')
  await race.press('export-picture')
  const preview = page.getByTestId('picture-preview')
  await expect(preview).toHaveAttribute('data-ready', 'true')
  await expect(page.getByTestId('picture-code')).not.toBeChecked()
  await expect(preview.locator('.qr-code')).toHaveCount(0)
  await page.getByTestId('picture-code').check()
  await expect(preview.locator('.qr-code')).toHaveCount(1)
  await expectClean(page, 'picture dialog with code')
  const [download] = await Promise.all([page.waitForEvent('download'), race.press('picture-png-2')])
  const saved = { name: download.suggestedFilename(), bytes: await readFile(await download.path()) }
  const alone = await shownAlone(page, saved, 'image/png', 'img')
  expect(textOfCode(await drawnPixels(alone, 'img'))).toBe(link)
})
