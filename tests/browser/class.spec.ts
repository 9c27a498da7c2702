/** A class computes a comparison: shares, their files, and the whole that is put together from them. */
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { type Browser, expect, test } from '@playwright/test'
import { textOfPng } from '../../www/src/share/png'
import { expectClean } from './axe'
import { ClassPage, commandLine, DOCUMENT, forged, longer, type Named, RUNS } from './class_page'
import { ComparisonPage, documentText, holdRunsAfter, letRuns } from './comparison_page'
import { zipOf } from './zips'

/** The journals of all shares, each done in a browser of its own. */
async function journalsOf(browser: Browser, link: string, shares: number): Promise<Named[]> {
  const journals: Named[] = []
  for (let share = 1; share <= shares; share++) {
    const student = await ClassPage.at(browser, link.replace('?/', `${share}/`))
    journals.push(await student.doShare())
    await student.page.context().close()
  }
  return journals
}

test.describe('three shares', () => {
  test.slow()
  let teacher: ClassPage
  let journals: Named[]
  let link: string

  test.beforeEach(async ({ page, browser }) => {
    teacher = new ClassPage(page)
    await teacher.openQuestion()
    link = await teacher.shareOut(3)
    await page.getByTestId('class-copy').click()
    await teacher.leaveDialog()
    journals = await journalsOf(browser, link, 3)
  })

  test('give the very files of the unbroken runs, on the page and by the command line', async ({
    browser,
  }) => {
    expect(await teacher.states()).toEqual(['missing', 'missing', 'missing'])
    // Whoever drops the next while one is read loses none.
    await Promise.all(journals.slice(0, 2).map((journal) => teacher.dropFiles(journal)))
    await expect(teacher.page.getByTestId('class-sum')).toContainText('2 of 3 shares are in')
    expect(await teacher.states()).toEqual(['in', 'in', 'missing'])
    // What came stays through a reload, with the files that brought it.
    await expect.poll(() => teacher.keptRuns()).toBe(6)
    await teacher.page.reload()
    await expect(teacher.page.getByTestId('class-file')).toHaveCount(2)
    await teacher.page.getByTestId('class-files').setInputFiles({
      name: journals[2]?.[0] ?? '',
      mimeType: '',
      buffer: Buffer.from(journals[2]?.[1] ?? ''),
    })
    await teacher.finished()
    await expect(teacher.page.getByTestId('class-sum')).toHaveText(
      `3 of 3 shares are in · ${RUNS} of ${RUNS} runs`,
    )

    const alone = await ClassPage.at(browser, 'about:blank')
    await alone.page.goto(link.replace(/#.*/, '#lab'))
    await alone.ready()
    const { files } = await alone.script({ document: DOCUMENT })
    for (const kind of ['csv', 'json'] as const)
      expect(await teacher.resultFile(kind)).toBe(files[kind])
    // Whose runs were timed is told how long a share takes.
    await alone.shareOut(3)
    await expect(alone.page.getByTestId('class-size')).toHaveText(
      /^A share has up to 4 runs\. About 1 s on a computer like this one\.$/,
    )

    const folder = mkdtempSync(join(tmpdir(), 'formicarium-class-'))
    const run = commandLine(folder)
    test.skip(!run, 'FORMICARIUM_CLI does not name the command line tool')
    writeFileSync(join(folder, 'small.json'), DOCUMENT)
    run?.('compare', 'small.json', '--out', 'whole')
    const of = (dir: string, ending: string) =>
      readFileSync(join(folder, dir, `small.${ending}`), 'utf8')
    expect(of('whole', 'csv')).toBe(files.csv)
    // Some of the shares are done by browsers, one by the command line.
    run?.('compare', 'small.json', '--out', 'shares', '--shard', '2/3')
    for (const [name, text] of [journals[0], journals[2]] as Named[])
      writeFileSync(join(folder, 'shares', name), text)
    run?.('compare', 'small.json', '--out', 'merged', '--merge', 'shares')
    for (const ending of ['csv', 'json', 'md', 'tests.md'])
      expect(of('merged', ending), ending).toBe(of('whole', ending))
  })

  test('that are spoilt are refused by name, and nothing of them is kept', async () => {
    const [[name, text] = ['', '']] = journals
    const lines = text.split('\n')
    const other = (wrong: string) => [`wrong-${name}`, wrong] as Named
    const page = teacher.page
    for (const [spoilt, says] of [
      [text.replace('"turns":', '"turns": '), /Line 2: it is damaged or was changed/],
      [text.replace(/"engine":"[^"]+"/, '"engine":"9.8.7"'), /engine 9\.8\.7 has done these runs/],
      [text.replace('journal@2', 'journal@1'), /another version, formicarium\/journal@1/],
      [text.replace(/"experiment":"\w{4}/, '"experiment":"0000'), /it needs the comparison 0000/],
      [
        forged(text, 2, (body) => body.replace('"length":', '"length":0')),
        /Line 2: it was changed/,
      ],
      [
        forged(text, 3, (body) => body.replace(/"task":\d+/, '"task":99')),
        /Line 3: it is a run that/,
      ],
    ] as const) {
      await teacher.dropFiles(other(spoilt))
      await expect(teacher.refused).toContainText(says)
      await expect(teacher.refused).toContainText(`wrong-${name} was not taken in`)
      await expect(page.getByTestId('class-file')).toHaveCount(0)
      await page.getByTestId('class-dismiss').click()
      await expect(teacher.refused).toHaveCount(0)
    }
    expect(await teacher.done()).toBe(0)
    // A file that ends within a line has brought the others; which one is missing is told.
    await teacher.dropFiles([name, lines.slice(0, -1).join('\n').slice(0, -9)])
    await expect(page.getByTestId('class-file')).toContainText('ends in the middle of a line')
    expect((await teacher.states())[0]).toBe('partly')
    // The whole one fills what is missing; the runs that were there are the same.
    await teacher.dropFiles([name, text])
    await expect(page.getByTestId('class-file')).toHaveCount(2)
    expect((await teacher.states())[0]).toBe('in')
  })

  test('that came twice are told; one that says something else is named with the other', async () => {
    const [[name, text] = ['', '']] = journals
    const page = teacher.page
    await teacher.dropFiles([name, text])
    await teacher.dropFiles([`again-${name}`, text])
    const row = page.getByTestId('class-share').first()
    await expect(row).toContainText('came twice')
    await expect(row).toContainText('3 were there already, the same')
    expect(await teacher.done()).toBe(3)
    await teacher.dropFiles([`liar-${name}`, forged(text, 2, longer)])
    await expect(teacher.refused).toContainText(`it says something else than ${name}`)
    await expect(teacher.refused).toContainText(/ants on Small, seed \d/)
    // Its runs go with the file, after a reload as well.
    await page.getByTestId('class-remove').first().press('Enter')
    await expect(page.getByRole('heading', { name: 'Shares of the class' })).toBeFocused()
    await expect(page.getByTestId('class-file')).toHaveCount(1)
    expect(await teacher.done()).toBe(0)
    await expect.poll(() => teacher.keptRuns()).toBe(0)
    await page.reload()
    await expect(page.getByTestId('class-file')).toHaveCount(1)
    expect(await teacher.done()).toBe(0)
  })

  test('with a forged run are found by a sample, which names it', async () => {
    const [[name, text] = ['', ''], second = ['', '']] = journals
    const page = teacher.page
    // As course pages hand them out: all in one archive.
    const all: Named[] = [[`liar-${name}`, forged(text, 2, longer)], second]
    await teacher.dropFiles(['class.zip', zipOf(all)])
    await expect(page.getByTestId('class-file')).toHaveCount(2)
    await page.getByTestId('class-sample-share').fill('100')
    await page.getByTestId('class-sample').click()
    const found = page.getByTestId('class-forged')
    await expect(found).toContainText('1 of 6 repeated runs')
    await expect(found).toContainText(new RegExp(`liar-${name}: ants on Small, seed \\d`))
    await expect(found).toContainText(/it says length [\d.]+; here came length [\d.]+/)
    await expectClean(page, 'a forged run')
    await page.getByTestId('class-remove-forged').click()
    await expect(page.getByTestId('class-file')).toHaveCount(1)
    await expect.poll(() => teacher.done()).toBe(3)
    await page.getByTestId('class-sample').click()
    await expect(page.getByTestId('class-sampled')).toHaveText(
      '3 runs repeated: the same, bit for bit.',
    )
  })

  test('as a picture carry the same runs', async ({ browser }) => {
    const student = await ClassPage.at(browser, link.replace('?/', '1/'))
    await student.page.getByTestId('share-start').click()
    await student.stage('done')
    const download = await student.download('share-picture')
    const picture = readFileSync(await download.path())
    expect(download.suggestedFilename()).toMatch(/^small\.\w{16}\.shard-1of3\.png$/)
    expect(await textOfPng(picture)).toBe(journals[0]?.[1])
    await teacher.dropFiles([download.suggestedFilename(), picture])
    await expect(teacher.page.getByTestId('class-file')).toContainText('shard-1of3.png')
    expect((await teacher.states())[0]).toBe('in')
    await student.page.context().close()
  })

  test('need their comparison, and say which', async ({ browser }) => {
    const other = await ClassPage.at(browser, link.replace(/#.*/, '#lab'))
    await other.ready()
    const [[name, text] = ['', '']] = journals
    const { experiment } = JSON.parse(text.split('\n')[0] ?? '')
    await other.dropFiles([name, text])
    await expect(other.page.getByTestId('toast-warning')).toContainText(
      `${name} holds runs of the comparison ${experiment}, which is not open`,
    )
    await other.page.context().close()
  })
})

test.describe('a student’s tab', () => {
  test('waits for a share and a press, and tells how much there is', async ({ page, browser }) => {
    const teacher = new ClassPage(page)
    await teacher.openQuestion()
    const link = await teacher.shareOut(3)
    await expect(page.getByTestId('class-size')).toContainText('A share has up to 4 runs.')
    await expect(page.getByTestId('class-links')).toContainText('&share=3/3')
    await expectClean(page, 'sharing out')
    const [name, text] = await teacher.saved('class-save-all')
    expect(name).toBe('small.shares.txt')
    expect(text.trim().split('\n')).toEqual([1, 2, 3].map((i) => link.replace('?/', `${i}/`)))

    const student = await ClassPage.at(browser, link)
    await student.stage('choosing')
    await expect(student.page.getByTestId('lab-go-on')).toHaveCount(0)
    await student.page.getByTestId('share-draw').click()
    await student.stage('ready')
    await expect(student.page.getByTestId('share-is')).toHaveText(/^Share [123] of 3: [34] runs$/)
    await student.type('share-number', 2)
    await expect(student.page.getByTestId('share-is')).toHaveText('Share 2 of 3: 3 runs')
    await expectClean(student.page, 'a share before it starts')
    // Nothing has run; which share it is stays through a reload.
    expect(await student.done()).toBe(0)
    await student.page.reload()
    await expect(student.page.getByTestId('share-is')).toHaveText('Share 2 of 3: 3 runs')
    expect(await student.done()).toBe(0)
    await student.page.getByTestId('share-start').press('Enter')
    await student.stage('done')
    await expect(student.page.getByTestId('share-is')).toBeFocused()
    await expect(student.page.getByTestId('part-of-all')).toHaveText(
      `Below are 3 of ${RUNS} runs of the whole comparison.`,
    )
    await expectClean(student.page, 'a share that is done')
    await student.page.context().close()
  })

  test('goes on after a reload in the middle of a share', async ({ page }) => {
    const student = new ClassPage(page)
    await holdRunsAfter(page, 1)
    await student.openQuestion()
    const link = await student.shareOut(2)
    await student.leaveDialog()
    await page.goto('about:blank')
    await page.goto(link.replace('?/', '2/'))
    await page.getByTestId('share-start').click()
    await expect.poll(() => student.done()).toBe(1)
    await student.stage('begun')
    await page.reload()
    await expect(page.getByTestId('share-is')).toHaveText('1 of 5 runs of this share are done.')
    await page.getByTestId('lab-go-on').click()
    await letRuns(page)
    await student.stage('done')
    const [name, text] = await student.saved('share-save')
    expect(name).toMatch(/^small\.\w{16}\.shard-2of2\.journal$/)
    expect(text.trim().split('\n')).toHaveLength(1 + 5)
  })

  test('is there without a link, where that would be too long, and can be left', async ({
    page,
  }) => {
    const student = new ClassPage(page)
    // Cells that nothing makes shorter.
    let state = 1
    const cell = () => {
      state = (state * 48271) % 2147483647
      return state % 3 === 0 ? '@' : '.'
    }
    const rows = Array.from({ length: 300 }, () => Array.from({ length: 300 }, cell).join(''))
    rows[0] = '.'.repeat(300)
    await student.openQuestion(
      documentText({ entries: [{ id: 'exact', planner: 'astar' }], seeds: 4, rows }).replace(
        '[299,299]',
        '[299,0]',
      ),
    )
    await page.getByTestId('lab-share').click()
    await page.getByTestId('lab-share-class').click()
    await expect(page.getByTestId('class-too-long')).toContainText('Hand out the result file')
    await page.getByTestId('class-here').click()
    await student.stage('choosing')
    await page.getByTestId('share-leave').click()
    await expect(page.getByTestId('share-card')).toHaveCount(0)
    await expect(page.getByTestId('lab-go-on')).toBeVisible()
    expect(await student.done()).toBe(0)
  })

  test('refuses a share that there is not, by its name', async ({ page }) => {
    const teacher = new ClassPage(page)
    await teacher.openQuestion()
    const link = await teacher.shareOut(3)
    for (const share of ['4/3', '0/3', 'x', '1/200000']) {
      await page.goto('about:blank')
      await page.goto(link.replace('?/3', share))
      await expect(page.getByTestId('toast-error')).toContainText(`There is no share “${share}”`)
      await expect(page.getByTestId('builder')).toBeVisible()
    }
  })
})

test('files with more runs than the page takes are refused unread, with the way that takes them', async ({
  page,
}) => {
  const comparison = new ComparisonPage(page)
  await comparison.open()
  for (const [name, begins, says] of [
    ['huge.json', '{"format":"formicarium/comparison@1","rows":[', 'formicarium compare huge.json'],
    ['huge.journal', '{"format":"formicarium/journal@2","engine":"0.1.0"', '--merge FOLDER'],
  ] as const) {
    const read = await page.evaluate(
      async ([name, begins]) => {
        const megabyte = new Uint8Array(1 << 20).fill(32)
        const file = new File([begins, ...Array(280).fill(megabyte)], name)
        let most = 0
        const whole = Blob.prototype.arrayBuffer
        Blob.prototype.arrayBuffer = function () {
          most = Math.max(most, this.size)
          return whole.call(this)
        }
        const data = new DataTransfer()
        data.items.add(file)
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }))
        await new Promise((done) => setTimeout(done, 1500))
        Blob.prototype.arrayBuffer = whole
        return most
      },
      [name, begins] as const,
    )
    const toast = page.getByTestId('toast-error').filter({ hasText: name })
    await expect(toast).toContainText('more runs than the page takes: 281 MB')
    await expect(toast).toContainText(says)
    expect(read).toBeLessThanOrEqual(64 * 1024)
  }
})

for (const locale of ['en', 'zh-CN'])
  test.describe(`on a phone in ${locale}`, () => {
    test.use({ locale })

    test('a share and the collection fit @phone', async ({ page }) => {
      test.slow()
      const teacher = new ClassPage(page)
      await teacher.openQuestion(
        documentText({ entries: [{ id: 'ants', planner: 'ant-system' }], seeds: 4 }),
      )
      const link = await teacher.shareOut(2)
      await page.getByTestId('class-copy').click()
      const fits = () =>
        page.evaluate(
          () => document.documentElement.scrollWidth <= document.documentElement.clientWidth,
        )
      expect(await fits()).toBe(true)
      await expectClean(page, 'sharing out on a phone')
      await teacher.leaveDialog()
      await expect(page.getByTestId('class-card')).toBeVisible()
      expect(await fits()).toBe(true)
      await expectClean(page, 'collecting on a phone')
      await page.goto('about:blank')
      await page.goto(link)
      await teacher.stage('choosing')
      expect(await fits()).toBe(true)
      await expectClean(page, 'a share on a phone')
    })
  })
