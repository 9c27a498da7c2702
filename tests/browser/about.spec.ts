/** Whoever opens a link is told what it is, and links that programs have changed open all the same. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { RacePage } from './race_page'

const linkOf = (name: string) =>
  readFileSync(join(__dirname, `../fixtures/links/0.1.0/${name}.link`), 'utf8').trim()
const SESSION = linkOf('session')
const STUDY = linkOf('study')

async function openedAbout(page: Page, link: string): Promise<void> {
  await page.goto(`./${link}`)
  await page.getByTestId('received-what').click()
  await expect(page.getByTestId('about-citation')).toBeVisible()
}

const boxes = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('.header, .toolbar, .workbench, [data-testid=play]')].map((one) =>
      JSON.stringify(one.getBoundingClientRect()),
    ),
  )

test('a first visit is offered no explanation; an opened link is, and nothing moves when it goes', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.open()
  await expect(page.getByTestId('received')).toHaveCount(0)
  await page.goto(`./${SESSION}`)
  await page.reload()
  await expect(page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
  // Who has been there knows it.
  await expect(page.getByTestId('received')).toHaveCount(0)
})

test('the offer lies over the page', async ({ page }) => {
  await page.goto(`./${SESSION}`)
  await expect(page.getByTestId('received')).toBeVisible()
  await page.getByTestId('play').click()
  await expect(page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
  const before = await boxes(page)
  await page.getByTestId('received-hide').click()
  await expect(page.getByTestId('received')).toHaveCount(0)
  expect(await boxes(page)).toEqual(before)
})

test('a race is explained: what it is, that it was verified here, how good it is, and how to cite it', async ({
  page,
}) => {
  await openedAbout(page, SESSION)
  const about = page.getByTestId('about')
  await expect(page.getByTestId('about-verified')).toContainText('Yes, here and now')
  await expect(page.getByTestId('about-best')).toContainText('38.97')
  await expect(page.getByTestId('about-best')).toContainText('proven')
  const rows = page.getByTestId('about-runs').locator('tbody tr')
  await expect(rows).toHaveCount(2)
  await expect(rows.first()).toContainText('Ant System')
  await expect(rows.first()).toContainText('49.90 after 8 iterations')
  await expect(rows.first()).toContainText('+28.0%')
  await expect(rows.first()).toContainText('verified')
  const { panels, seed } = await new RacePage(page).session()
  const citation = await page.getByTestId('about-citation').innerText()
  expect(citation).toMatch(/^Formicarium \d+\.\d+\.\d+\. /)
  expect(citation).toContain(`36 × 22 cells; seed ${seed}`)
  expect(panels).toHaveLength(2)
  expect(citation).toContain('digest 7a12b5943ac70739')
  await expectClean(page, 'about a result')
  // It is not offered again.
  await page.keyboard.press('Escape')
  await expect(about).toHaveCount(0)
  await expect(page.getByTestId('received')).toHaveCount(0)
})

test('what comes next is one press away', async ({ page }) => {
  await openedAbout(page, SESSION)
  const { seed } = await new RacePage(page).session()
  await page.getByTestId('about-seed').click()
  await expect(page.getByTestId('about-dialog')).toHaveCount(0)
  await expect.poll(async () => (await new RacePage(page).session()).seed).not.toBe(seed)
  await page.getByTestId('share').click()
  await page.getByTestId('share-about').click()
  await page.getByTestId('about-share').click()
  await expect(page.getByTestId('share-link')).toBeVisible()
  await page.getByTestId('share-about').click()
  await page.getByTestId('about-compare').click()
  await expect(page).toHaveURL(/#lab/)
})

test('a race without recorded runs has nothing to verify', async ({ page }) => {
  await new RacePage(page).open()
  await page.getByTestId('share').click()
  await page.getByTestId('share-about').click()
  await expect(page.getByTestId('about-verified')).toContainText('nothing to verify')
  await expect(page.getByTestId('about-runs')).toContainText('nothing recorded')
})

test('a comparison is explained before and after it was verified', async ({ page }) => {
  await openedAbout(page, STUDY)
  await expect(page.getByTestId('about')).toContainText('Frozen: two maps, three planners')
  await expect(page.getByTestId('about')).toContainText('30 runs, engine 0.1.0')
  await expect(page.getByTestId('about-verified')).toContainText('Not yet')
  await expect(page.getByTestId('about-citation')).toContainText(/comparison digest [0-9a-f]{16}/)
  await expectClean(page, 'about a result')
  await page.getByTestId('about-run').click()
  await expect(page.getByTestId('verification')).toHaveAttribute('data-state', 'same')
  await page.getByTestId('lab-share').click()
  await page.getByTestId('lab-share-about').click()
  await expect(page.getByTestId('about-verified')).toContainText('Yes, here and now')
})

test('in Chinese, on a phone, dark', { tag: '@phone' }, async ({ page }) => {
  await page.addInitScript(() => {
    localStorage.setItem('formicarium.language', 'zh-CN')
    localStorage.setItem('formicarium.theme', 'dark')
  })
  await openedAbout(page, SESSION)
  await expect(page.getByTestId('about-verified')).toContainText('逐位相同')
  await expect(page.getByTestId('about')).not.toContainText(/about\./)
  const wide = await page.getByTestId('about').evaluate((one) => one.scrollWidth > one.clientWidth)
  expect(wide).toBe(false)
  await expectClean(page, 'about a result')
})

test.describe('links that programs have changed', () => {
  for (const [how, change] of [
    ['# as a code in the path', (link: string) => link.replace('#', '%23')],
    ['# and = as codes in the path', (link: string) => encodeURIComponent(link)],
    [
      'codes of codes in the query',
      (link: string) => `?${encodeURIComponent(encodeURIComponent(link))}`,
    ],
    ['= as a code', (link: string) => link.replace('=', '%3D')],
    ['a full stop and a word behind it', (link: string) => `${link}.%20Look`],
    ['what tracks behind it', (link: string) => `${link}&utm_source=mail&fbclid=Iw`],
  ] as [string, (link: string) => string][]) {
    test(`a session opens with ${how}`, async ({ page }) => {
      await page.goto(`./${change(SESSION)}`)
      await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
      expect(new URL(page.url()).hash).toMatch(/^#x=/)
      expect(new URL(page.url()).pathname).not.toContain('x')
    })

    test(`a comparison opens with ${how}`, async ({ page }) => {
      await page.goto(`./${change(STUDY)}`)
      await expect(page.getByTestId('run-bar')).toContainText('Frozen: two maps, three planners')
    })
  }

  test('a link that lost its end says how much, in both languages', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    const link = (await race.shareLink()).split('#')[1] ?? ''
    const all = link.length - 2
    await race.paste(`#${link.slice(0, -12)} and more`)
    const toast = page.getByTestId('toast-error').last()
    await expect(toast).toContainText(`12 of its ${all} characters are missing`)
    await page.getByTestId('language').click()
    await page.getByTestId('language-zh-CN').click()
    await expect(page.locator('html')).toHaveAttribute('lang', /^zh/)
    await race.paste(`#${link.slice(0, -7)}`)
    await expect(page.getByTestId('toast-error').last()).toContainText(
      `共 ${all} 个字符，缺少 7 个`,
    )
  })
})
