/** Shares of a comparison: how a link names them, how long they take, which of their runs are repeated. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { workOf } from '../../../www/src/lab/run/estimate'
import { drawSample } from '../../../www/src/lab/run/sample'
import { Tasks } from '../../../www/src/lab/run/tasks'
import { decodeFragment, encodeDocument, PREFIX } from '../../../www/src/share/comparison_link'
import { LinkError } from '../../../www/src/share/link_error'
import { linkIn } from '../../../www/src/share/link_in_text'
import { readShare, shareEnding, shareText } from '../../../www/src/share/share_of_class'
import { documentText } from '../comparison_page'

const DOCUMENT = '{"format": "formicarium/comparison@1"}'

async function refusal(hash: string): Promise<LinkError> {
  const error = await decodeFragment(hash).then(
    () => null,
    (thrown: unknown) => thrown,
  )
  expect(error, hash).toBeInstanceOf(LinkError)
  return error as LinkError
}

test('a share is written in one way', () => {
  for (const share of [
    { index: 3, of: 30 },
    { index: null, of: 2 },
    { index: 1, of: 1 },
  ])
    expect(readShare(shareText(share))).toEqual(share)
  for (const text of [
    '0/3',
    '4/3',
    '03/30',
    '+1/3',
    '1',
    '1/',
    '/3',
    '1/3/3',
    '?/0',
    '?/?',
    '３/30',
    '',
  ])
    expect(() => readShare(text), text).toThrow(LinkError)
})

test('a link carries a share behind its text, and what is no share is refused by name', async () => {
  const link = PREFIX + (await encodeDocument(DOCUMENT))
  expect(await decodeFragment(link)).toEqual({ document: DOCUMENT, numbers: null })
  for (const index of [3, null]) {
    const whole = link + shareEnding({ index, of: 30 })
    expect(whole.slice(link.length)).toBe(index === null ? '&share=?/30' : '&share=3/30')
    expect((await decodeFragment(whole)).share).toEqual({ index, of: 30 })
    // As programs write it that take signs for codes.
    expect((await decodeFragment(encodeURI(whole).replace('?', '%3F'))).share?.index).toBe(index)
    // Within what somebody pastes.
    expect(linkIn(`Open ${whole} please.`)).toBe(whole)
  }
  for (const ending of [
    '&share=31/30',
    '&share=x',
    '&share=',
    '&part=3/30',
    '&share=1/3&more=1',
    '&',
  ])
    expect((await refusal(link + ending)).kind, ending).toBe('link-share')
  expect((await refusal(`${link}&share=31/30`)).message).toContain('31/30')
})

test('a sample has a part of all runs, at least one of each file, and none twice', () => {
  const files = new Map([
    [1, Array.from({ length: 90 }, (_, i) => i)],
    [2, Array.from({ length: 9 }, (_, i) => 100 + i)],
    [3, [200]],
    [4, []],
  ])
  let state = 1
  const chance = () => {
    state = (state * 48271) % 2147483647
    return state / 2147483647
  }
  for (const [part, count] of [
    [0.01, 3],
    [0.02, 3],
    [0.1, 10],
    [0.5, 50],
    [1, 100],
  ] as const) {
    const drawn = drawSample(files, part, chance)
    expect(drawn).toHaveLength(count)
    expect(new Set(drawn).size).toBe(count)
    for (const runs of [files.get(1), files.get(2), files.get(3)])
      expect(runs?.some((run) => drawn.includes(run))).toBe(true)
  }
  // Every run of a file is as likely as any other.
  const hits = new Map<number, number>()
  for (let turn = 0; turn < 900; turn++)
    for (const run of drawSample(new Map([[1, [0, 1, 2]]]), 0.1, chance))
      hits.set(run, (hits.get(run) ?? 0) + 1)
  for (const run of [0, 1, 2]) expect(hits.get(run)).toBeGreaterThan(240)
  expect(drawSample(new Map(), 0.02, chance)).toEqual([])
})

test('the work of all runs follows from those that were timed, entry by entry', () => {
  // One map, two entries, three seeds each.
  const table = new Uint32Array([0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 1, 1, 0, 1, 2, 0, 1, 3])
  const order = new Uint32Array([0, 3, 1, 4, 2, 5])
  const tasks = new Tasks({ tasks: table, order })
  const run = (index: number, ...seconds: number[]) => ({ index, row: '', seconds, found: true })
  const all = tasks.inOrder()
  expect(workOf(tasks, all, [run(0, 1), run(1, 0.5, 3)])).toBeNull()
  // Runs of others are not timed.
  expect(workOf(tasks, all, [run(0, 1), run(1, 3), run(3)])).toBeNull()
  expect(workOf(tasks, all, [run(0, 1), run(1, 3), run(3, 10)])).toBe(3 * 2 + 3 * 10)
  expect(workOf(tasks, all, [run(0, 1), run(1, 3), run(2, 2)])).toBe(6 * 2)
})

test('the engine deals, writes, takes in and lets go of shares', async () => {
  const pkg = join(__dirname, '../../../pkg')
  const engine: typeof import('@pkg/formicarium') = await import(
    `${join(pkg, 'formicarium.js')}?class`
  )
  engine.initSync({ module: readFileSync(join(pkg, 'formicarium_bg.wasm')) })
  const document = documentText({ entries: [{ id: 'exact', planner: 'astar' }], seeds: 5 })
  const whole = new engine.Comparison(document)
  const dealt = [1, 2].map((share) => [...whole.dealt(`${share}/2`)])
  expect(dealt.flat().sort()).toEqual([0, 1, 2, 3, 4])
  for (const index of dealt[0] ?? []) whole.keep(whole.run(index, () => 1).row, [1])
  const journal = whole.journal('1/2')
  expect(engine.journal_digest(new TextEncoder().encode(journal))).toBe(whole.digest())
  expect(engine.journal_digest(new Uint8Array())).toBeUndefined()

  const other = new engine.Comparison(document)
  const taken = other.take_journal(journal)
  expect(taken.shard).toBe('1/2')
  expect(taken.runs.map(({ index }) => index)).toEqual(dealt[0])
  expect(taken.runs.map(({ row }) => row)).toEqual(whole.rows())
  expect(other.take_journal(journal)).toMatchObject({ new: 0, same: dealt[0]?.length, runs: [] })
  const [gone = 0] = dealt[0] ?? []
  other.forget(gone)
  expect([...other.open_tasks()]).toContain(gone)
  // What was let go of is new again, and nothing is left that says otherwise.
  expect(other.take_journal(journal).runs.map(({ index }) => index)).toEqual([gone])
  expect(other.verify()?.deviations).toEqual([])
})
