import { readFile } from 'node:fs/promises'
import AxeBuilder from '@axe-core/playwright'
import { type Browser, type Download, expect, type Page, test } from '@playwright/test'
import { decodeFragment, encodeDocument, PREFIX } from '../../www/src/share/comparison_link'
import { seal } from '../../www/src/share/envelope'
import { textOfPng } from '../../www/src/share/png'
import { ComparisonPage, documentText } from './comparison_page'
import { RacePage } from './race_page'

const ENTRIES = [
  { id: 'ants', planner: 'ant-system', set: { iterations: 10, ants: 5 } },
  { id: 'exact', planner: 'astar' },
]
const DOCUMENT = documentText({ entries: ENTRIES, seeds: 4 })
/** One map, two entries, four seeds. */
const RUNS = 8

// biome-ignore lint/suspicious/noExplicitAny: a document made invalid on purpose has no type
type Spoilt = any

async function link(page: Page): Promise<string> {
  await page.getByTestId('lab-share').click()
  const field = page.getByTestId('lab-share-link')
  await expect(field).toHaveValue(/#q=/)
  const value = await field.inputValue()
  await page.keyboard.press('Escape')
  return value
}

/** The same link with its document changed, and its checksum right. */
async function changed(address: string, change: (document: Spoilt) => void): Promise<string> {
  const { numbers, ...carried } = await decodeFragment(address)
  const document = JSON.parse(carried.document)
  change(document)
  return `${address.split('#')[0]}${PREFIX}${await encodeDocument(JSON.stringify(document), numbers)}`
}

/** The page in a browser context of its own, which shares nothing with the first. */
async function elsewhere(browser: Browser, address: string): Promise<Page> {
  const page = await (await browser.newContext()).newPage()
  await page.goto(address)
  return page
}

async function saved(page: Page, testId: string): Promise<Download> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(testId).click(),
  ])
  return download
}

const bytesOf = async (download: Download) => readFile(await download.path())

/** Drops a file anywhere on the page. */
async function drop(page: Page, name: string, content: Buffer | string): Promise<void> {
  const base64 = Buffer.from(content).toString('base64')
  const transfer = await page.evaluateHandle(
    ([fileName, text]) => {
      const data = new DataTransfer()
      const bytes = Uint8Array.from(atob(text ?? ''), (char) => char.charCodeAt(0))
      data.items.add(new File([bytes], fileName ?? ''))
      return data
    },
    [name, base64],
  )
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer })
}

const panel = (page: Page) => page.getByTestId('verification')
const state = (page: Page) => expect(panel(page))

async function verifyAll(page: Page): Promise<void> {
  await page.getByTestId('verify-again').click()
}

test.describe('a comparison as a link', () => {
  let address = ''

  test.beforeEach(async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.script({ document: DOCUMENT })
    await comparison.finished()
    address = await link(page)
  })

  test('carries the question, is run again elsewhere and verified', async ({ browser }) => {
    expect(address.length).toBeLessThan(4000)
    const other = await elsewhere(browser, address)
    await expect(other.getByTestId('verification-recorded')).toHaveText(
      /^Recorded with engine \d+\.\d+\.\d+: 8 runs\.$/,
    )
    await state(other).toHaveAttribute('data-state', 'none')
    // All that the link carries is there at once.
    const sent = await decodeFragment(address)
    const { recorded } = JSON.parse(sent.document)
    const carried = other.getByTestId('carried-runs')
    for (const { digest } of recorded.runs[0]) await expect(carried).toContainText(digest)
    await expect(other.getByTestId('as-recorded')).toHaveText('as recorded, not verified here')
    for (const one of sent.numbers?.[0] ?? []) {
      await expect(carried).toContainText(`${one?.withPath} of 4 with a path`)
      await expect(carried).toContainText(`median ${one?.median?.toFixed(2)}`)
    }
    // Handed on before anything has run, it carries them still; a reload has them too.
    expect(await decodeFragment(await link(other))).toEqual(sent)
    await other.reload()
    await expect(carried).toContainText('4 of 4 with a path')
    await expect(other.getByTestId('run-bar')).toContainText('Small')
    await expect(other.getByTestId('lab-progress')).toHaveAttribute('aria-valuemax', '8')
    await verifyAll(other)
    await state(other).toHaveAttribute('data-state', 'same')
    await expect(other.getByTestId('verified')).toHaveText('verified: bit for bit')
    const { violations } = await new AxeBuilder({ page: other }).include('.verification').analyze()
    expect(violations).toEqual([])
    // The numbers are those of the runs here now; a link made there has the same digests and numbers.
    await expect(carried).toHaveCount(0)
    const again = await decodeFragment(await link(other))
    expect(JSON.parse(again.document)).toEqual(JSON.parse(sent.document))
    expect(again.numbers).toEqual(sent.numbers)
    // A reload goes on with the comparison instead of opening the link once more.
    await expect.poll(() => new ComparisonPage(other).keptRuns()).toBe(RUNS)
    await other.reload()
    await state(other).toHaveAttribute('data-state', 'same')
    await other.context().close()
  })

  test('of an earlier page, which tells no numbers, says so', async ({ browser }) => {
    const { document } = await decodeFragment(address)
    const earlier = `${address.split('#')[0]}${PREFIX}${await encodeDocument(document)}`
    const other = await elsewhere(browser, earlier)
    const carried = other.getByTestId('carried-runs')
    await expect(carried).toContainText('4 runs')
    await expect(carried).toContainText('are not in the link')
    await expect(other.getByTestId('as-recorded')).toHaveCount(0)
    await other.context().close()
  })

  test('with numbers of another question is refused by name', async ({ browser }) => {
    const { document, numbers } = await decodeFragment(address)
    const spoilt = await encodeDocument(document, [...(numbers ?? []), [null, null]])
    const other = await elsewhere(browser, `${address.split('#')[0]}${PREFIX}${spoilt}`)
    await expect(other.getByTestId('toast-error')).toContainText(
      'Numbers must have as many maps as the question, 1',
    )
    await expect(other.getByTestId('builder')).toBeVisible()
    await other.context().close()
  })

  test('a wrong digest is not explained away', async ({ browser }) => {
    const spoilt = await changed(address, ({ recorded }) => {
      recorded.runs[0][0].digest = '0123456789abcdef'
    })
    const other = await elsewhere(browser, spoilt)
    await verifyAll(other)
    await state(other).toHaveAttribute('data-state', 'refuted')
    await expect(panel(other)).toContainText(
      'though engine, question, maps and parameters are the same',
    )
    const listed = other.getByTestId('deviations').locator('li')
    await expect(listed).toHaveCount(1)
    await expect(listed).toContainText('ants on Small: the runs differ')
    await expect(listed).toContainText('Digest 0123456789abcdef was recorded')
    await other.context().close()
  })

  test('what may be the cause of a difference stands first', async ({ browser }) => {
    const spoilt = await changed(address, ({ recorded, question }) => {
      recorded.engine = '0.0.9'
      recorded.parameters[0].ants = 6
      recorded.parameters[0].gone = true
      recorded.runs[0][0].digest = '0123456789abcdef'
      question.asks = 'Something else?'
    })
    const other = await elsewhere(browser, spoilt)
    await verifyAll(other)
    await state(other).toHaveAttribute('data-state', 'differs')
    await expect(panel(other)).toContainText('What may be the cause stands first')
    const kinds = other.getByTestId('deviations').locator('li')
    await expect
      .poll(() => kinds.evaluateAll((all) => all.map((one) => (one as HTMLElement).dataset.kind)))
      .toEqual(['version', 'comparison', 'parameter', 'parameter', 'bits'])
    await expect(kinds.nth(0)).toContainText('The engine was 0.0.9')
    await expect(kinds.nth(2)).toHaveText('ants: ants was 6, now it is 5.')
    await expect(kinds.nth(3)).toContainText('there is no such parameter any more')
    await other.getByTestId('language').click()
    await other.getByTestId('language-zh-CN').click()
    await expect(panel(other)).toContainText('记录时引擎为 0.0.9')
    await other.context().close()
  })

  test('a part of it, or another version, gets a clear message and a usable page', async ({
    browser,
  }) => {
    for (const [spoilt, words] of [
      [address.slice(0, -40), 'damaged'],
      [`${address.slice(0, -60)}AAAAAAAA${address.slice(-52)}`, 'damaged'],
      [`${address.split('#')[0]}${PREFIX}${await seal(newer())}`, 'newest version'],
      [
        await changed(address, (d) => Object.assign(d, { format: 'formicarium/comparison@9' })),
        '@9',
      ],
      [
        await changed(address, ({ question }) => {
          question.entries[0].planner = 'bee-system'
        }),
        'bee-system',
      ],
    ] as const) {
      const other = await elsewhere(browser, spoilt)
      const toast = other.getByTestId('toast-error')
      await expect(toast).toContainText(new RegExp(words, 'i'))
      await expect(toast.locator('.toast-hint')).not.toBeEmpty()
      await expect(other.getByTestId('builder')).toBeVisible()
      await other.context().close()
    }
  })

  test('pasted into a page that shows a race, it opens', async ({ browser }) => {
    const other = await elsewhere(browser, address.split('#')[0] ?? '')
    const race = new RacePage(other)
    await race.ready()
    await race.paste(`Have a look: ${address}`)
    await expect(other.getByTestId('run-bar')).toContainText('Small')
    await expect(panel(other)).toBeVisible()
    await other.context().close()
  })
})

/** A container of a later version. */
function newer(): Uint8Array<ArrayBuffer> {
  const covered = Uint8Array.from([9, 0])
  const checksum = covered.reduce((hash, byte) => Math.imul(hash ^ byte, 0x01000193), 0x811c9dc5)
  const bytes = new Uint8Array(4 + covered.length)
  new DataView(bytes.buffer).setUint32(0, checksum >>> 0, true)
  bytes.set(covered, 4)
  return bytes
}

test.describe('a comparison as a file', () => {
  test('shows its runs at once, and they are tried by sample and as a whole', async ({
    page,
    browser,
  }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.script({ document: DOCUMENT })
    await comparison.finished()
    const whole = await page.evaluate(() => window.formicarium.resultFile('csv'))
    await page.getByTestId('lab-share').click()
    const file = await saved(page, 'lab-share-file')
    expect(file.suggestedFilename()).toBe('small.result.json')
    const content = await bytesOf(file)
    expect(JSON.parse(String(content)).rows).toHaveLength(RUNS)

    const other = await elsewhere(browser, page.url().split('#')[0] ?? '')
    await new RacePage(other).ready()
    await drop(other, file.suggestedFilename(), content)
    await expect(other.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
    expect(await other.evaluate(() => window.formicarium.resultFile('csv'))).toBe(whole)
    await expect(other.getByTestId('results')).toContainText('ants')
    await state(other).toHaveAttribute('data-state', 'none')

    await other.getByTestId('verify-seeds').fill('1')
    await other.getByTestId('verify-spot').click()
    await state(other).toHaveAttribute('data-state', 'partly')
    await expect(other.getByTestId('verified')).toHaveText('2 of 8 verified: bit for bit')
    await verifyAll(other)
    await expect(other.getByTestId('verified')).toHaveText('verified: bit for bit')
    // After a reload the runs are still the file's.
    await expect.poll(() => new ComparisonPage(other).keptRuns()).toBe(RUNS)
    await other.reload()
    await new ComparisonPage(other).finished()
    await expect(other.getByTestId('verification-recorded')).toContainText('8 runs')
    await state(other).toHaveAttribute('data-state', 'none')
    await other.context().close()
  })

  test('names the first seed that differs, and a file that was edited', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { files } = await comparison.script({ document: DOCUMENT })
    const document = JSON.parse(files.json)
    const digests = document.rows.map(({ digest }: { digest: string }) => digest)
    for (const place of [2, 3]) document.rows[place].digest = '0123456789abcdef'
    await drop(page, 'edited.json', JSON.stringify(document))
    // That the rows are not those of the digest shows without a run.
    await state(page).toHaveAttribute('data-state', 'refuted')
    await expect(page.getByTestId('deviations')).toContainText('ants on Small')
    await expect(page.getByTestId('deviations')).toContainText('They were edited')

    // Without its digests, a file is compared run by run.
    delete document.recorded
    await drop(page, 'rows.json', JSON.stringify(document))
    await expect(page.getByTestId('verification-recorded')).toContainText('the file does not say')
    await verifyAll(page)
    await state(page).toHaveAttribute('data-state', 'refuted')
    await expect(page.getByTestId('deviations')).toContainText(
      'ants on Small: 2 of the runs differ, the first with seed 3.',
    )
    expect(digests).toHaveLength(RUNS)
  })

  test('is handed on as what it is: runs of another engine stay that', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { files } = await comparison.script({ document: DOCUMENT })
    const document = JSON.parse(files.json)
    document.recorded.engine = '0.0.9'
    await drop(page, 'older.json', JSON.stringify(document))
    await expect(page.getByTestId('verification-recorded')).toContainText('0.0.9')
    await expect(page.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
    const again = JSON.parse(await page.evaluate(() => window.formicarium.resultFile('json')))
    expect(again.recorded).toEqual(document.recorded)
  })

  test('that is no comparison is refused by name', async ({ page }) => {
    await new ComparisonPage(page).open()
    const toast = page.getByTestId('toast-error')
    await drop(page, 'run.json', '{"format": "formicarium/result@1", "path": [[0,0]]}')
    await expect(toast).toContainText('single run')
    await expect(page.getByTestId('builder')).toBeVisible()
  })
})

test.describe('a comparison as a picture', () => {
  test('a result card and a figure open again by drop', async ({ page, browser }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { files } = await comparison.script({ document: DOCUMENT })
    await comparison.finished()
    await page.getByTestId('lab-share').click()
    const card = await saved(page, 'lab-share-picture')
    expect(card.suggestedFilename()).toBe('small.png')
    const picture = await bytesOf(card)
    expect(await textOfPng(picture)).toBe(files.json)
    // 1200 pixels wide, as its first chunk says.
    expect(picture.readUInt32BE(16)).toBe(1200)

    const other = await elsewhere(browser, page.url().split('#')[0] ?? '')
    await new RacePage(other).ready()
    await drop(other, 'small.png', picture)
    await expect(other.getByTestId('lab')).toHaveAttribute('data-phase', 'done')
    await verifyAll(other)
    await expect(other.getByTestId('verified')).toHaveText('verified: bit for bit')
    await other.context().close()
  })

  test('a figure carries it too', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    const { files } = await comparison.script({ document: DOCUMENT })
    await page.getByRole('tab', { name: 'Figures' }).click()
    const png = await bytesOf(await saved(page, 'figure-values-png'))
    expect(await textOfPng(png)).toBe(files.json)
  })

  test('a picture without one says what is missing, and is offered as a map', async ({ page }) => {
    await new ComparisonPage(page).open()
    await drop(page, 'screenshot.png', await page.screenshot())
    await expect(page.getByTestId('map-notices')).toContainText('No session is in this picture')
  })
})

test('a comparison that is too long for a link offers the file', async ({ page }) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  // Noise that no compression shortens: 200 × 200 cells.
  let seed = 1
  const noise = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) >>> 0
    return seed / 2 ** 32 < 0.4 ? '@' : '.'
  }
  const rows = Array.from({ length: 200 }, (_, y) =>
    Array.from({ length: 200 }, (_, x) => (x === y || x === y + 1 ? '.' : noise())).join(''),
  )
  await comparison.script({
    document: documentText({ entries: [{ id: 'exact', planner: 'astar' }], seeds: 1, rows }),
  })
  await page.getByTestId('lab-share').click()
  await expect(page.getByTestId('lab-share-too-long')).toContainText('8,000')
  await expect(page.getByTestId('lab-share-copy')).toHaveCount(0)
  const file = await saved(page, 'lab-share-file')
  expect(JSON.parse(String(await bytesOf(file))).rows).toHaveLength(1)
})
