import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Catalog, Question } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { zhCNEngine } from '../../../www/src/i18n/zh_cn/engine'
import { inChinese } from '../../../www/src/i18n/zh_cn/phrases'
import { zhCNQuestions } from '../../../www/src/i18n/zh_cn/questions'
import { zhCNSources } from '../../../www/src/i18n/zh_cn/sources'
import { ComparisonPage } from '../comparison_page'
import { RacePage } from '../race_page'
import { refusals } from './engine_literals'

const ROOT = join(__dirname, '../../..')
const PKG = join(ROOT, 'pkg')
const QUESTIONS = join(ROOT, 'experiments')
const TOML = join(ROOT, 'www/node_modules/smol-toml/dist/index.js')

/** What the whole engine offers, asked of the engine itself. */
async function wholeCatalog(): Promise<Catalog> {
  const engine = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  return engine.catalog()
}

/** How a robot drives, as the page calls it (drive/settings.tsx). */
async function drivingKeys(): Promise<string[]> {
  const engine = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  const rows: { key: string }[] = engine.drive_params()
  return rows.map(({ key }) => (key === 'iterations' ? 'plan_iterations' : key))
}

test('how a robot drives has Chinese names and meanings', async () => {
  const keys = await drivingKeys()
  expect(keys.length).toBeGreaterThan(0)
  for (const named of [zhCNEngine.paramNames, zhCNEngine.params])
    expect(Object.keys(named)).toEqual(expect.arrayContaining(keys))
})

test('everything in the catalog has a Chinese name', async () => {
  const { planners } = await wholeCatalog()
  const {
    planners: named,
    params,
    paramNames,
    units,
    options,
    presets,
    components,
    meanings,
  } = zhCNEngine
  const missing: string[] = []
  const look = (where: object, what: string, keys: string[]) => {
    for (const key of keys) if (!(key in where)) missing.push(`${what}.${key}`)
  }
  for (const planner of planners) {
    look(named, 'planners', [planner.id])
    look(
      presets,
      'presets',
      planner.presets.map(({ name }) => name),
    )
    look(
      components,
      'components',
      planner.components.map(({ id }) => id),
    )
    for (const { key, kind, unit } of planner.params) {
      look(params, 'params', [key])
      look(paramNames, 'paramNames', [key])
      if (unit) look(units, 'units', [unit])
      if (kind.type !== 'choice') continue
      const ids = kind.options.map(({ id }) => id)
      look(options, 'options', ids)
      // Options that are planners are told by their names.
      const told = ids.filter((id) => !(id in named))
      look((meanings as Record<string, object>)[key] ?? {}, `meanings.${key}`, told)
    }
  }
  expect([...new Set(missing)], 'add these to www/src/i18n/zh_cn/engine.ts').toEqual([])
})

test('no two parameters of a planner share a Chinese name, and none is left over', async () => {
  const { planners } = await wholeCatalog()
  const names: Record<string, string> = zhCNEngine.paramNames
  for (const { id, params } of planners) {
    const shown = params.map(({ key }) => names[key])
    expect([...new Set(shown)], id).toEqual(shown)
  }
  const keys = new Set(planners.flatMap(({ params }) => params.map(({ key }) => key)))
  for (const key of await drivingKeys()) keys.add(key)
  expect(Object.keys(names).filter((key) => !keys.has(key))).toEqual([])
  for (const name of Object.values(names)) expect(name).toMatch(/^\p{Script=Han}+$/u)
})

/** Texts that are not among the known ones, each once. */
const unknown = (texts: (string | null | undefined)[], known: Record<string, string>) => [
  ...new Set(texts.filter((text) => text && !Object.hasOwn(known, text))),
]

test('every source in the catalog, and what presets mean, has Chinese', async () => {
  const { planners } = await wholeCatalog()
  const texts = planners.flatMap(({ source, params, presets }) => [
    source,
    ...params.map((param) => param.source),
    ...presets.flatMap((preset) => [preset.source, preset.meaning]),
  ])
  expect(texts.length).toBeGreaterThan(100)
  expect(unknown(texts, zhCNSources), 'add these to www/src/i18n/zh_cn/sources.ts').toEqual([])
  const said = new Set(texts)
  const stale = Object.keys(zhCNSources).filter((text) => !said.has(text))
  expect(stale, 'no longer in the catalog').toEqual([])
})

async function questions(folder = QUESTIONS): Promise<Question[]> {
  const { parse } = await import(TOML)
  const files = readdirSync(folder).filter((file) => file.endsWith('.toml'))
  return files.map((file) => parse(readFileSync(join(folder, file), 'utf8')))
}

/** The name of a map; null for one that a generator has made, which is told by kind, size and seed. */
function nameOf(map: string): string | null {
  const { name } = JSON.parse(readFileSync(join(QUESTIONS, map), 'utf8'))
  return /^[a-z]+-\d+x\d+-seed\d+$/.test(name) ? null : name
}

/** What the page shows of a question; maps that are public are not here, so that they have no names. */
function textsOf(
  { title, paper, asks, instances, entries, claims = [], facts = [] }: Question,
  named = (map: string): string | null => nameOf(map),
) {
  return [
    title,
    paper,
    asks,
    ...instances.flatMap(({ map, note }) => [named(map), note]),
    ...entries.flatMap(({ label, missing }) => [label, missing]),
    ...claims.flatMap(({ says, note }) => [says, note]),
    ...facts.map(({ says }) => says),
  ]
}

test('every text of the papers’ questions has Chinese', async () => {
  const all = await questions()
  expect(all.length).toBeGreaterThan(5)
  const onPublicMaps = await questions(join(QUESTIONS, 'public'))
  expect(onPublicMaps.length).toBeGreaterThan(0)
  const texts = [
    ...all.flatMap((question) => textsOf(question)),
    ...onPublicMaps.flatMap((question) => textsOf(question, () => null)),
  ]
  expect(unknown(texts, zhCNQuestions), 'add these to www/src/i18n/zh_cn/questions.ts').toEqual([])
  const said = new Set<string | null | undefined>(texts)
  const stale = Object.keys(zhCNQuestions).filter((text) => !said.has(text))
  expect(stale, 'no longer in experiments/').toEqual([])
})

test.describe('on a Chinese page', () => {
  test.use({ locale: 'zh-CN' })

  test('sources of parameters are told in Chinese', async ({ page }) => {
    await new RacePage(page).open()
    const alpha = page.locator('.parameter', { has: page.getByTestId('param-alpha') })
    const source = alpha.locator('.source')
    await expect(source).toContainText('Dorigo 与 Stützle 2004，框 3.1')
    await page.getByTestId('language').click()
    await page.getByTestId('language-en').click()
    await expect(source).toContainText('Dorigo and Stützle 2004, box 3.1')
  })

  test('parameters, their options and what is wrong with them are told in Chinese', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.open()
    const control = (key: string) =>
      page.locator('.parameter', { has: page.getByTestId(`param-${key}`) })
    await expect(control('alpha').locator('label')).toHaveText('α信息素因子')
    await page.getByTestId('param-alpha').fill('999')
    await page.getByTestId('param-alpha').blur()
    const error = control('alpha').locator('.field-error')
    await expect(error).toHaveText(
      /^信息素因子 = 999 超出范围 0 至 \d+。请选择 0 与 \d+ 之间的值。$/,
    )
    await (await race.param('heuristic')).selectOption('goal')
    const back = control('heuristic').getByRole('button')
    await expect(back).toHaveAccessibleName(/恢复为“绕行量”$/)
  })

  test('what is wrong with a file is told in Chinese', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await race.menu('map-menu', 'open-import')
    await page.getByTestId('import-area').fill('type octile\nheight 2\nwidth 2\nmap\n..\n')
    await page.getByTestId('import-text').click()
    await expect(page.getByRole('alert').first()).toContainText(
      '地图应有 2 行，到第 1 行就结束了。应为：每行一排格子。',
    )
  })

  test('a paper’s question is told in Chinese, and its files are the same as ever', async ({
    page,
  }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await page.getByTestId('published-seeds-threshold').fill('1')
    await page.getByTestId('published-run-threshold').click()
    await comparison.finished()
    const title = page.getByTestId('run-bar').getByRole('heading')
    await expect(title).toHaveText('自适应阈值蚁群算法与 ACO 和 ACOMSP')
    await page.getByTestId('asked').locator('summary').click()
    await expect(page.getByTestId('asked')).toContainText('手绘。')
    await page.getByTestId('results-tab-reported').click()
    const claim = page.getByTestId('verdicts').locator('tbody th').first()
    await expect(claim).toContainText('路径更短')
    const files = () =>
      page.evaluate(() =>
        Promise.all(
          (['csv', 'markdown', 'latex'] as const).map((kind) =>
            window.formicarium.resultFile(kind),
          ),
        ),
      )
    const inChinese = await files()
    expect(inChinese.join()).toContain('Ant colony with an adaptive threshold against ACO')
    expect(inChinese.join()).not.toMatch(/\p{Script=Han}/u)
    await page.getByTestId('language').click()
    await page.getByTestId('language-en').click()
    await expect(title).toHaveText('Ant colony with an adaptive threshold against ACO and ACOMSP')
    await expect(claim).toContainText('shorter paths')
    expect(await files()).toEqual(inChinese)
  })
})

/** Every file of the engine's source below a folder, without its tests. */
function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name)
    if (entry.isDirectory()) return entry.name === 'cli' ? [] : sources(path)
    return entry.name.endsWith('.rs')
      ? [readFileSync(path, 'utf8').split('#[cfg(test)]')[0] ?? '']
      : []
  })
}

test('every remark of the engine about a file, and every error of one, has Chinese', () => {
  const source = sources(join(ROOT, 'src')).join('\n')
  const told = (call: string) => [
    ...new Set(
      [...source.matchAll(new RegExp(`${call}\\(\\s*"([a-z0-9-]+)"`, 'g'))].map(([, kind]) => kind),
    ),
  ]
  const missing = (kinds: (string | undefined)[], known: object) =>
    kinds.filter((kind) => kind && !(kind in known))
  const remarks = told('Notice::new')
  expect(remarks.length).toBeGreaterThan(40)
  expect(missing(remarks, zhCNEngine.notices), 'notices').toEqual([])
  // What scripts and comparisons pass wrongly is told in the words of the engine.
  const engines = [
    'bad-argument',
    'cell-count',
    'question-field',
    'unknown-parameter',
    'unknown-preset',
  ]
  expect(missing(told('ErrorReport::new'), zhCNEngine.errors).sort(), 'errors').toEqual(engines)
})

test('what is wrong with a file, and what should stand there, has Chinese', () => {
  const texts = sources(join(ROOT, 'src/formats')).flatMap(refusals)
  expect(texts.length).toBeGreaterThan(250)
  // Lists of keys and bare values are the same in every language.
  const sentences = texts.filter((text) => /[a-z]{2,} [a-z]{2,}/.test(text))
  expect(sentences.length).toBeGreaterThan(150)
  const fillings = ['7', 'scale', 'start', 'the goal']
  const untold = sentences.filter((text) =>
    fillings.every((filling) => {
      const english = text.replaceAll('{}', filling)
      return inChinese(english) === english
    }),
  )
  expect(untold, 'add these to zh_cn/file_faults.ts or file_rules.ts').toEqual([])
})

test('each flaw of a drawn path has Chinese of its own, with the places that it names', () => {
  const flaws = readFileSync(join(ROOT, 'src/path.rs'), 'utf8')
    .split('enum Flaw')[1]
    ?.split('\n}')[0]
  const texts = [...(flaws ?? '').matchAll(/#\[error\("([^"]+)"/g)].map(([, text = '']) => text)
  expect(texts.length).toBeGreaterThan(8)
  const told = texts.map((text) => inChinese(text.replaceAll(/\{[a-z0-9]*\}/g, '7')))
  expect(told.filter((text) => /[a-z]/.test(text))).toEqual([])
  expect(new Set(told).size).toBe(texts.length)
  expect(inChinese('cell 4 of the path, (2, 9), is blocked')).toContain('(2, 9)')
  expect(
    inChinese(
      'step 3 of the path, from (1, 2) to (5, 6), cuts a corner, is too steep or is no allowed move',
    ),
  ).toContain('从 (1, 2) 到 (5, 6)')
})

test('phrases keep what differs from case to case, the fullest first', () => {
  expect(inChinese('row 3 has 5 numbers where the first row has 4')).toBe(
    '第 3 行有 5 个数，而第一行有 4 个',
  )
  expect(inChinese('5 is none of the 2 matrices of the file')).toBe(
    '文件中有 2 个矩阵，没有第 5 个',
  )
  expect(inChinese('a whole number from 0 to 9')).toBe('0 至 9 的整数')
  expect(inChinese('1 to 9')).toBe('1 至 9')
  expect(inChinese('nobody has said this before')).toBe('nobody has said this before')
})
