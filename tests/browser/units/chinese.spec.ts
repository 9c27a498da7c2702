/** The Chinese of page, cards and reports: one word for one term, and the signs of Chinese. */
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'

const ROOT = join(__dirname, '../../..')
const WORDS = join(ROOT, 'www/src/i18n/zh_cn')
const CARDS = join(ROOT, 'docs/zh')
const REPORTS = 'src/comparison/report/words/zh_cn.rs'

/** Words that were used for a term beside the one that it has. */
const RETIRED: Record<string, string> = {
  蒸发: '挥发',
  构建: '构造',
  转弯指标: '转弯指数',
  单元扩展: '扩展格数',
  启发值: '启发信息',
  条目: '参评项',
  组成部分: '组件',
  重现论文: '复现论文',
  死路: '死胡同',
  路线: '巡回',
  您: '你',
  本代: '本次迭代',
}

/** Of these a longer word is meant. */
const ALLOWED = /发布构建|\d+ 条路线|一半的路线|其组成部分/g

/** Commas of formulas and of places. */
const FORMULAS = /\([ij], 终点\)|\[列, 行\]/g

interface Line {
  at: string
  text: string
}

/** Every text with Chinese in it: literals of the dictionaries and reports, lines of the cards without what is code. */
function chinese(): Line[] {
  const dictionaries = readdirSync(WORDS).flatMap((file) =>
    [...readFileSync(join(WORDS, file), 'utf8').matchAll(/'((?:[^'\\\n]|\\.)*)'/g)].map(
      ([, text = '']) => ({ at: file, text }),
    ),
  )
  const cards = readdirSync(CARDS, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.md'))
    .flatMap((file) =>
      readFileSync(join(CARDS, file), 'utf8')
        .replace(/```[\s\S]*?```/g, '')
        .replace(/\]\([^)]*\)/g, ']')
        .split('\n')
        .map((text) => ({ at: file, text })),
    )
  const literals = readFileSync(join(ROOT, REPORTS), 'utf8').matchAll(/"((?:[^"\\]|\\[\s\S])*)"/g)
  const reports = [...literals].map(([, text = '']) => ({
    at: REPORTS,
    text: text.replace(/\\\n\s*/g, ''),
  }))
  return [...dictionaries, ...cards, ...reports].filter(({ text }) => /\p{Script=Han}/u.test(text))
}

test('every term has one word', () => {
  const wrong = chinese().flatMap(({ at, text }) =>
    Object.entries(RETIRED)
      .filter(([word]) => text.replace(ALLOWED, '').includes(word))
      .map(([word, right]) => `${at}: ${word}, should be ${right}: ${text.slice(0, 60)}`),
  )
  expect(wrong).toEqual([])
})

test('signs are those of Chinese', () => {
  const half = /\p{Script=Han}[,;:?!]|[,;:?!] ?\p{Script=Han}|\p{Script=Han} +\p{Script=Han}|\d %/u
  const wrong = chinese().filter(({ text }) => half.test(text.replace(FORMULAS, '')))
  expect(wrong).toEqual([])
})
