/** The gallery's lessons as files: what the command line makes of their questions, and texts that say what was measured. */
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { enLessons } from '../../../www/src/i18n/en/lessons'
import { zhCNLessons } from '../../../www/src/i18n/zh_cn/lessons'
import { LONGEST } from '../../../www/src/model/names'
import { readDocument } from '../../../www/src/share/session_document'
import { cli } from '../tracker_folder'

const ROOT = join(__dirname, '../../..')
const LESSONS = join(ROOT, 'www/lessons')
const QUESTIONS = join(ROOT, 'experiments/lessons')

const MEASURED: Record<string, Record<string, string | number>> = JSON.parse(
  readFileSync(join(LESSONS, 'measured.json'), 'utf8'),
)
const IDS = Object.keys(MEASURED)
const sessionOf = (id: string) =>
  readDocument(JSON.parse(readFileSync(join(LESSONS, `${id}.experiment.json`), 'utf8')))

type Texts = Record<'title' | 'line' | 'labels' | 'note' | 'question' | 'answer', string>
const LANGUAGES: [string, Record<string, Texts>][] = [
  ['English', enLessons.each],
  ['Chinese', zhCNLessons.each],
]

test('each question has a lesson, each lesson a session and texts', () => {
  expect(IDS.length).toBe(10)
  const sorted = [...IDS].sort()
  const named = (folder: string, ending: string) =>
    readdirSync(folder)
      .filter((file) => file.endsWith(ending))
      .map((file) => file.slice(0, -ending.length))
      .sort()
  expect(named(QUESTIONS, '.toml')).toEqual(sorted)
  expect(named(LESSONS, '.experiment.json')).toEqual(sorted)
  for (const [, texts] of LANGUAGES) expect(Object.keys(texts).sort()).toEqual(sorted)
})

for (const [language, all] of LANGUAGES)
  test(`${language} names every number that was measured, and no other`, () => {
    for (const [id, texts] of Object.entries(all)) {
      const said = Object.values(texts).join(' ')
      const named = new Set([...said.matchAll(/\{\{(\w+)\}\}/g)].map(([, key]) => key))
      expect([...named].sort(), id).toEqual(Object.keys(MEASURED[id] ?? {}).sort())
      const { panels } = sessionOf(id)
      const labels = texts.labels.split('\n')
      expect(labels.length, id).toBe(panels.length)
      expect(texts.title.length).toBeLessThanOrEqual(LONGEST.title)
      for (const label of labels) expect(label.length).toBeLessThanOrEqual(LONGEST.label)
      expect(`${texts.note}\n\n${texts.question}`.length).toBeLessThan(LONGEST.note)
    }
  })

test('each carries something of a lesson, and all kinds are there but guesses', () => {
  const parts = IDS.flatMap((id) => Object.keys(sessionOf(id).lesson ?? {}))
  expect(parts.length).toBeGreaterThanOrEqual(IDS.length)
  expect([...new Set(parts)].sort()).toEqual(['drawn', 'stops', 'target'])
})

test.describe('the command line', () => {
  test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')

  test('writes the same lessons again: digests, numbers, and what each answer says holds', () => {
    test.slow()
    const folder = mkdtempSync(join(tmpdir(), 'formicarium-lessons-'))
    const script = join(QUESTIONS, 'write.mjs')
    execFileSync(process.execPath, [script, '--cli', cli ?? '', '--into', folder])
    expect(readdirSync(folder).sort()).toEqual(readdirSync(LESSONS).sort())
    for (const file of readdirSync(folder)) {
      const [again, kept] = [folder, LESSONS].map((where) =>
        readFileSync(join(where, file), 'utf8'),
      )
      expect(again, file).toBe(kept)
    }
  })
})
