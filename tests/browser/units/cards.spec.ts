/** docs/zh tells in Chinese what docs/papers and docs/methodology.md tell: the same numbers, tables, commands and links. */
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, join, normalize } from 'node:path'
import { expect, test } from '@playwright/test'
import { zhCNComponents } from '../../../www/src/i18n/zh_cn/components'

const DOCS = join(__dirname, '../../../docs')
const CARDS = [
  ...readdirSync(join(DOCS, 'papers'))
    .filter((file) => file.endsWith('.md'))
    .map((file) => `papers/${file}`),
  'methodology.md',
]

const read = (file: string) => readFileSync(join(DOCS, file), 'utf8')

/** How often each text occurs. */
function counted(texts: Iterable<string>): Map<string, number> {
  const counts = new Map<string, number>()
  for (const text of texts) counts.set(text, (counts.get(text) ?? 0) + 1)
  return counts
}

const found = (text: string, pattern: RegExp) => [...text.matchAll(pattern)].map(([all]) => all)

/** Months are numbers in Chinese alone. */
const numbers = (text: string) => found(text.replace(/\d+ 月/g, ''), /\d+(?:[.,]\d+)*/g)
const spans = (text: string) => found(text.replace(/```[\s\S]*?```/g, ''), /`[^`\n]+`/g)

/** What is to be typed; what a comment says of it may be in any language. */
const commands = (text: string) =>
  found(text, /```sh\n[\s\S]*?```/g)
    .flatMap((listing) => listing.split('\n'))
    .map((line) => line.replace(/ # .*$/, '').trimEnd())
    .filter((line) => !line.startsWith('```'))

/** Where links lead, files seen from docs; heads of chapters have their own names in each language. */
function targets(text: string, file: string): string[] {
  return [...text.matchAll(/\]\(([^)\s]+)\)/g)].map(([, target = '']) => {
    if (/^https?:/.test(target)) return target
    const seen = normalize(join(dirname(file), target.replace(/#.*$/, '')))
    // A chapter of the document itself.
    return seen === 'zh' ? '.' : seen.replace(/^zh\//, '')
  })
}

/** Columns of every row of every table, and the levels of headings, in order. */
const shape = (text: string) =>
  text.split('\n').flatMap((line) => {
    if (line.startsWith('|')) return [`${line.split(/(?<!\\)\|/).length - 2} columns`]
    return /^#+(?= )|^- /.exec(line)?.[0] ?? []
  })

for (const card of CARDS) {
  test.describe(card, () => {
    const chinese = `zh/${card}`

    test('is there in Chinese', () => {
      expect(existsSync(join(DOCS, chinese)), `write docs/${chinese}`).toBe(true)
      expect(read(chinese)).toMatch(/^# .*\p{Script=Han}/u)
    })

    test('has every number as often as in English', () => {
      const [english, translated] = [counted(numbers(read(card))), counted(numbers(read(chinese)))]
      const lost = [...english].filter(([number, times]) => (translated.get(number) ?? 0) < times)
      expect(lost, 'numbers of the English card').toEqual([])
      const made = [...translated].filter(([number, times]) => (english.get(number) ?? 0) < times)
      expect(made, 'numbers of the Chinese card alone').toEqual([])
    })

    test('has the same tables, heads, commands, names and links', () => {
      const [english, translated] = [read(card), read(chinese)]
      expect(shape(translated)).toEqual(shape(english))
      expect(commands(translated)).toEqual(commands(english))
      expect(spans(translated).sort()).toEqual(spans(english).sort())
      expect(targets(translated, chinese).sort()).toEqual(targets(english, card).sort())
    })
  })
}

test('cards call components as the page does', () => {
  const known = new Map(Object.entries(zhCNComponents))
  const rows = CARDS.flatMap((card) => [
    ...read(`zh/${card}`).matchAll(/^\| ([^|]+) \(`([a-z-]+)`\) \| ([^|]+) \| `\w+=/gm),
  ])
  expect(rows.length).toBeGreaterThan(20)
  for (const [, name, id = '', adds] of rows) expect({ name, adds }, id).toEqual(known.get(id))
})
