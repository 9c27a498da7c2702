import { readFile } from 'node:fs/promises'
import { expect, test } from '@playwright/test'
import { packBits, unpack } from '../../www/src/share/codec'
import { open, seal } from '../../www/src/share/envelope'
import { textOfPng } from '../../www/src/share/png'
import { freshRace, RacePage } from './race_page'

test.describe('share links', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('restore map, planners, parameters and seed, replay the run and verify it', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await page.getByTestId('parameters-1').click()
    await page.getByTestId('param-ants').fill('23')
    await page.getByTestId('param-ants').press('Enter')
    await page.getByTestId('seed').fill('77')
    await page.getByTestId('seed').press('Enter')
    await race.drag([
      [4, 19],
      [9, 19],
    ])
    await race.menu('add-panel', 'add-astar')
    await race.ready()
    const before = await page.evaluate(() => window.formicarium.run({ iterations: 6 }))
    const link = await race.shareLink()
    expect(link.length).toBeLessThan(8000)
    const session = await race.session()

    const other = await freshRace(browser, link)
    const opened = await other.session()
    expect(opened.scenario).toEqual(session.scenario)
    expect(opened.seed).toBe(77)
    expect(opened.panels.map(({ planner, params }) => [planner, params])).toEqual(
      session.panels.map(({ planner, params }) => [planner, params]),
    )
    for (const place of [1, 2, 3]) {
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    }
    await expect(other.page.getByTestId('verified-1')).toContainText('6 iterations')
    await other.page.getByTestId('reset').click()
    await other.ready()
    const again = await other.page.evaluate(() => window.formicarium.run({ iterations: 6 }))
    expect(again[0]?.summary?.digest).toBe(before[0]?.summary?.digest)
    await other.page.context().close()
  })

  test('a finished run is verified as well', async ({ page, browser }) => {
    const race = new RacePage(page)
    await page.evaluate(() => window.formicarium.run())
    const other = await freshRace(browser, await race.shareLink())
    await expect(other.page.getByTestId('verified-1')).toHaveAttribute(
      'data-verified',
      'verified',
      { timeout: 20_000 },
    )
    await expect(other.page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
    await other.page.context().close()
  })

  test('a tampered digest is said to differ', async ({ page, browser }) => {
    const race = new RacePage(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    const link = await race.shareLink()
    const other = await freshRace(browser, await withDigest(link, 'feedfacecafebeef'))
    await expect(other.page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'differs')
    await expect(other.page.getByTestId('verified-2')).toHaveAttribute('data-verified', 'verified')
    await other.page.context().close()
  })

  test('a generated map travels as its generator call', async ({ page, browser }) => {
    const race = new RacePage(page)
    await race.menu('map-menu', 'gallery-random-100')
    await expect(page.getByTestId('gallery-random-100')).toHaveAttribute('aria-checked', 'true')
    await race.ready()
    await race.drag([
      [50, 50],
      [55, 50],
    ])
    const link = await race.shareLink()
    expect(link.length).toBeLessThan(1500)
    const other = await freshRace(browser, link)
    expect((await other.session()).scenario).toEqual((await race.session()).scenario)
    await other.page.context().close()
  })

  for (const [what, spoil] of [
    ['cut short', (link: string) => link.slice(0, link.indexOf('#x=') + 60)],
    ['changed in the middle', (link: string) => `${link.slice(0, -40)}AAAAAAAA${link.slice(-32)}`],
    ['changed in one character', (link: string) => withChangedCharacter(link)],
    ['not base64url', (link: string) => `${link.split('#')[0]}#x=%F0%9F%90%9C!`],
    ['empty', (link: string) => `${link.split('#')[0]}#x=`],
  ] as [string, (link: string) => string][]) {
    test(`a link that is ${what} gets a clear message and a usable page`, async ({
      page,
      browser,
    }) => {
      const link = spoil(await new RacePage(page).shareLink())
      const other = await freshRace(browser, link)
      const toast = other.page.getByTestId('toast-error')
      await expect(toast).toContainText('damaged')
      await expect(toast.locator('.toast-hint')).not.toBeEmpty()
      await expect.poll(() => other.antMoves()).toBeGreaterThan(0)
      await other.page.context().close()
    })
  }

  test('a foreign fragment is simply not ours', async ({ browser, page }) => {
    const other = await freshRace(browser, `${page.url().split('#')[0]}#section-3`)
    await expect.poll(() => other.antMoves()).toBeGreaterThan(0)
    await other.page.context().close()
  })

  test('a link pasted into an open page is opened', async ({ page }) => {
    const race = new RacePage(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 2 }))
    const link = await race.shareLink()
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.paste(`Look at this: ${link}`)
    await expect.poll(() => race.walls()).toBeGreaterThan(0)
    await expect(page.getByTestId('verified-1')).toHaveAttribute('data-verified', 'verified')
  })

  test('a picture of the race carries it, and is dropped on the page', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await page.evaluate(() => window.formicarium.run({ iterations: 3 }))
    await page.getByTestId('share').click()
    await expect(page.getByTestId('share-picture')).toBeEnabled()
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId('share-picture').click(),
    ])
    const png = await readFile(await download.path())
    // Two panels beside each other, and the whole link inside.
    expect(png.readUInt32BE(16)).toBeGreaterThan(png.readUInt32BE(20))
    expect(await textOfPng(png)).toMatch(/^http:.*#x=[\w-]+$/)
    const session = await race.session()

    const other = await freshRace(browser, page.url().split('#')[0] ?? '')
    await other.page.getByTestId('reset').click()
    const transfer = await other.page.evaluateHandle((base64) => {
      const data = new DataTransfer()
      const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0))
      data.items.add(new File([bytes], 'race.png'))
      return data
    }, png.toString('base64'))
    await other.page.dispatchEvent('main', 'drop', { dataTransfer: transfer })
    for (const place of [1, 2])
      await expect(other.page.getByTestId(`verified-${place}`)).toHaveAttribute(
        'data-verified',
        'verified',
      )
    expect((await other.session()).scenario).toEqual(session.scenario)
    await other.page.context().close()
  })
})

/** Amid the map's bits, where nothing but the checksum can notice. */
function withChangedCharacter(link: string): string {
  const at = link.length - 30
  return `${link.slice(0, at)}${link[at] === 'x' ? 'y' : 'x'}${link.slice(at + 1)}`
}

/** The same link with another digest for the first panel. */
async function withDigest(link: string, digest: string): Promise<string> {
  const [address, fragment] = link.split('#x=')
  const session = await unpack(await open(fragment ?? ''), () =>
    Promise.reject(new Error('no generator here')),
  )
  const [first, ...rest] = session.panels
  if (!first?.result) throw new Error('the link carries no result')
  const panels = [{ ...first, result: { ...first.result, digest } }, ...rest]
  return `${address}#x=${await seal(packBits({ ...session, panels }, '0.1.0'))}`
}
