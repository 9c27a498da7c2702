/** Every lazy part names all its files: what a browser would fetch by itself as it imports one is lost for good where that fails. */
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { withAllNames } from '../../../www/part_names'

const ASSETS = join(__dirname, '../../../www/dist/assets')

test('lists are completed, from the table or in place', () => {
  const known: Record<string, string[]> = {
    'page.js': ['first.js'],
    'lab.js': ['late.js', 'first.js'],
    'late.js': ['runtime.js'],
  }
  const imports = (file: string) => known[file] ?? []
  const code = (table: string, lab: string, alone: string) =>
    `const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=[${table}])))=>i;` +
    `a(()=>import(\`./lab.js\`).then(e=>e.t),__vite__mapDeps([${lab}]),import.meta.url);` +
    `b(()=>import("./late.js"),[${alone}],import.meta.url)`
  const before = code('"./lab.js","./lab.css"', '0,1', '')
  const after = code(
    '"./lab.js","./lab.css","./late.js","./runtime.js"',
    '0,1,2,3',
    '"./late.js","./runtime.js"',
  )
  expect(withAllNames(before, 'page.js', imports)).toBe(after)
  expect(withAllNames(after, 'page.js', imports)).toBe(after)
})

test('the built page has no part with a file that it does not name', () => {
  const scripts = readdirSync(ASSETS).filter((name) => name.endsWith('.js'))
  const codes = new Map(scripts.map((name) => [name, readFileSync(join(ASSETS, name), 'utf8')]))
  const imports = (file: string) =>
    [...(codes.get(file) ?? '').matchAll(/(?:from|import)\s*["'`]\.\/([^"'`]+\.js)["'`]/g)].map(
      ([, name = '']) => name,
    )
  let parts = 0
  for (const [name, code] of codes) {
    if (name.includes('.worker-')) continue
    parts += code.match(/import\(/g)?.length ?? 0
    expect(withAllNames(code, name, imports), name).toBe(code)
  }
  expect(parts).toBeGreaterThan(50)
})
