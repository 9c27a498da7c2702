import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { csvOf } from '../../../www/src/lab/run/csv'
import { timesCsv } from '../../../www/src/lab/run/times_csv'

test('no cell is a formula, and numbers stay', () => {
  // The engine's own test has the same lines.
  const lines = [
    ['=HYPERLINK("x")', -0.5, 'a,b'],
    ['@x', 1e-7, '-3'],
    ['\tx', 2, 'plain\nline'],
    ['–', -1, '-x'],
    ['+1+1', '+1e-7', '\r=1'],
    [undefined, '', '-inf'],
  ]
  expect(csvOf(['a', 'b', 'c'], lines)).toBe(
    'a,b,c\n' +
      `"'=HYPERLINK(""x"")",-0.5,"a,b"\n` +
      `'@x,1e-7,-3\n` +
      `'\tx,2,"plain\nline"\n` +
      `–,-1,'-x\n` +
      `'+1+1,+1e-7,"'\r=1"\n` +
      ',,-inf\n',
  )
})

test('times have the guard', () => {
  const question = { instances: [{ id: '-a1' }], entries: [{ id: '=1+1,"x"' }] }
  const row = JSON.stringify({ task: { instance: 0, entry: 0, seed: 3 } })
  const runs = [{ index: 0, row, seconds: [0.5, 1], found: true }]
  expect(timesCsv(question as never, runs as never)).toBe(
    `instance,entry,seed,seconds_to_best,seconds\n'-a1,"'=1+1,""x""",3,0.500000,1.000000\n`,
  )
})

test('nothing else on the page writes CSV', () => {
  const source = join(__dirname, '../../../www/src')
  const files = readdirSync(source, { recursive: true }).map(String)
  const texts = files.filter((file) => /\.tsx?$/.test(file))
  const joining = texts.filter((file) =>
    /join\('[,;]'\)/.test(readFileSync(join(source, file), 'utf8')),
  )
  expect(joining).toEqual(['lab/run/csv.ts'])
})
