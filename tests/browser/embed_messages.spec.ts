/** Every block of docs/embedding.md about messages, run as it stands; and who is answered, and who is not. */
import { expect, type Page, test } from '@playwright/test'
import { ARGUMENTS } from '../../www/src/model/embed_messages'
import { asScript, blocksOf, docText } from './doc_blocks'
import { Course, home, ParentPage } from './parent_page'

const TEXT = docText('embedding.md')
/** The last is for Node.js. */
const BLOCKS = blocksOf(TEXT, 'js').slice(0, -1)

let course: Course

test.beforeAll(async () => {
  course = await Course.open()
})
test.afterAll(() => course.close())

test('every block of the page about messages gives what it says', async ({ page }) => {
  test.slow()
  const parent = await ParentPage.around(page, course, '?embed')
  await parent.ready()
  expect(BLOCKS.length).toBeGreaterThan(2)
  const { code, values } = asScript(BLOCKS)
  const told = (await page.evaluate(code)) as [string, unknown, unknown][]
  expect(values).toBeGreaterThan(14)
  expect(told).toHaveLength(values)
  for (const [what, given, expected] of told) expect(given, what).toEqual(expected)
})

test('the table of messages has every request, and each of its fields', () => {
  for (const [kind, fields] of Object.entries(ARGUMENTS)) {
    const row = new RegExp(`^\\| \`${kind}\` \\| (.*?) \\|`, 'm').exec(TEXT)?.[1] ?? ''
    expect(row.match(/\w+/g) ?? [], kind).toEqual(fields)
  }
})

test('what is asked before the page is ready waits', async ({ page }) => {
  const parent = await ParentPage.around(page, course, '?embed')
  const asked = page.evaluate(async () => {
    const frame = document.querySelector('iframe')?.contentWindow
    const answered = () =>
      (window as unknown as { heard: { data: { id?: number } }[] }).heard.some(
        ({ data }) => data.id === 7,
      )
    // From the moment its scripts run.
    while (!answered()) {
      frame?.postMessage({ formicarium: 1, kind: 'version', id: 7 }, '*')
      await new Promise((resolve) => setTimeout(resolve, 20))
    }
  })
  await asked
  const [first] = (await parent.heard()).filter(({ data }) => data.id === 7)
  expect(first?.data).toMatchObject({ formicarium: 1, kind: 'answer', value: expect.any(String) })
})

test('wrong requests are answered with a typed error, unknown ones not at all', async ({
  page,
}) => {
  const parent = await ParentPage.around(page, course, '?embed')
  await parent.ready()
  const before = (await parent.heard()).length
  for (const unknown of [
    { formicarium: 1, kind: 'stop', id: 1 },
    { formicarium: 2, kind: 'version', id: 2 },
    { kind: 'version', id: 3 },
    { formicarium: 1, kind: 'constructor', id: 4 },
    'version',
    null,
  ])
    await parent.send(unknown)
  const wrong = await parent.answer({ formicarium: 1, kind: 'look', id: 'a', iteration: 'now' })
  expect(wrong).toMatchObject({ kind: 'error', error: { kind: 'bad-option', field: 'iteration' } })
  expect(Object.keys(wrong.error as object).sort()).toEqual(['field', 'hint', 'kind', 'message'])
  expect((await parent.heard()).length).toBe(before + 1)
  const nameless = await parent.answer({ formicarium: 1, kind: 'pause', id: null })
  expect(nameless).toMatchObject({ kind: 'error', error: { kind: 'bad-option', field: 'id' } })
  const damaged = await parent.answer({
    formicarium: 1,
    kind: 'load',
    id: 9,
    source: 'https://example.org/#x=rubbish',
  })
  expect(damaged).toMatchObject({ kind: 'error', error: { kind: 'link-damaged' } })
})

test('the named origin is answered, and no other', async ({ page }) => {
  const parent = await ParentPage.around(page, course, `?embed&origin=${course.origin}`)
  await parent.ready()
  const told = await parent.answer({ formicarium: 1, kind: 'version', id: 1 })
  expect(told.kind).toBe('answer')
  expect(new Set((await parent.heard()).map(({ origin }) => origin))).toEqual(
    new Set([new URL(home()).origin]),
  )
})

for (const [who, query] of [
  ['a page that the address does not name', '?embed&origin=https://elsewhere.example.org'],
  ['a page that the address names without an origin', '?embed&origin=null'],
] as const)
  test(`${who} hears nothing that it asks for`, async ({ page }) => {
    const parent = await ParentPage.around(page, course, query)
    await expect(parent.inner.getByTestId('panel-1')).toBeVisible()
    await parent.inner.getByTestId('step-iteration').click()
    await parent.send({ formicarium: 1, kind: 'session', id: 1 })
    // Whatever would be said has been said before this.
    const frame = await parent.frame()
    await frame.evaluate(() => window.formicarium.run({ iterations: 2 }))
    const answers = (await parent.heard()).filter(({ data }) => data.kind !== 'event')
    expect(answers).toEqual([])
  })

test('only the parent is heard, not a page within or beside', async ({ page }) => {
  const parent = await ParentPage.around(page, course, '?embed')
  await parent.ready()
  const before = (await parent.heard()).length
  const frame = await parent.frame()
  // From itself: the right origin is not enough.
  await frame.evaluate(() => window.postMessage({ formicarium: 1, kind: 'version', id: 1 }, '*'))
  await frame.evaluate(() => window.formicarium.run({ iterations: 1 }))
  const answers = (await parent.heard()).slice(before).filter(({ data }) => data.kind !== 'event')
  expect(answers).toEqual([])
})

/** What a page without an origin hears that asks as soon as the frame is there; one has none that stands in a `data:` address. */
async function heardWithoutOrigin(page: Page, query: string): Promise<Record<string, unknown>[]> {
  const inner = `<iframe src="${home()}${query}" title="A race" width="600" height="400"></iframe>
    <script>
      const heard = []
      addEventListener('message', ({ data, source }) => {
        heard.push(data)
        if (data.event === 'ready') source.postMessage({ formicarium: 1, kind: 'version', id: 5 }, '*')
      })
    </script>`
  course.html = `<iframe src="data:text/html,${encodeURIComponent(inner)}" width="700" height="500"></iframe>`
  await page.goto(course.origin)
  const [, parent] = page.frames()
  const heard = () => parent?.evaluate('heard') as Promise<Record<string, unknown>[]>
  await expect.poll(async () => (await heard()).length).toBeGreaterThan(0)
  await page.frames()[2]?.evaluate(() => window.formicarium.run({ iterations: 2 }))
  return heard()
}

test('a page without an origin is answered where it is named', async ({ page }) => {
  const heard = await heardWithoutOrigin(page, '?embed&amp;origin=null')
  expect(heard).toContainEqual(
    expect.objectContaining({ kind: 'answer', id: 5, value: expect.any(String) }),
  )
})

test('a page without an origin that is not named learns that the frame is there, and no more', async ({
  page,
}) => {
  expect(await heardWithoutOrigin(page, '?embed')).toEqual([
    { formicarium: 1, kind: 'event', event: 'ready' },
  ])
})

test('a page of its own answers nobody', async ({ page }) => {
  const parent = await ParentPage.around(page, course, '')
  await expect(parent.inner.getByTestId('play')).toBeVisible()
  await parent.send({ formicarium: 1, kind: 'session', id: 1 })
  const frame = await parent.frame()
  await frame.waitForFunction(() => window.formicarium?.session() !== null)
  await frame.evaluate(() => window.formicarium.run({ iterations: 1 }))
  expect(await parent.heard()).toEqual([])
})
