/** Which folder of the page may import which: the table in CONTRIBUTING.md, and the linter that holds it. */
import { spawnSync } from 'node:child_process'
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'

const ROOT = join(__dirname, '../../..')
const SOURCE = join(ROOT, 'www/src')
/** In every folder of `lab/`, beside its own row. */
const OF_LAB =
  /Inside `lab`, each folder may import (.*), and:/.exec(
    readFileSync(join(ROOT, 'CONTRIBUTING.md'), 'utf8'),
  )?.[1] ?? ''
const words = (text: string) => [...text.matchAll(/[\w/*]+/g)].map(([word]) => word)

/** By folder what it may import; `app` may import everything and is not among them. */
function table(): Map<string, string[]> {
  const text = readFileSync(join(ROOT, 'CONTRIBUTING.md'), 'utf8')
  const rows = [...text.matchAll(/^\| `([\w/]+)` \|[^|]*\| ([^|]*) \|$/gm)]
  const row = ([, folder = '', may = '']: RegExpExecArray): [string, string[]] => [
    folder,
    folder.startsWith('lab/') ? [...words(OF_LAB), ...words(may)] : words(may),
  ]
  return new Map(rows.map(row).filter(([folder]) => folder !== 'app'))
}

const folders = readdirSync(SOURCE, { withFileTypes: true })
  .filter((entry) => entry.isDirectory() && entry.name !== 'styles')
  .map(({ name }) => name)
const ofLab = readdirSync(join(SOURCE, 'lab'), { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => `lab/${name}`)

/** A new file in each folder of the table, importing everything that stands beside or above it. */
function attempts(folder: string): { line: string; allowed: boolean }[] {
  const may = table().get(folder) ?? []
  const [top, inside] = folder.split('/')
  const others = [...folders, ...(inside ? ofLab : [])].filter((o) => o !== folder && o !== top)
  return others.flatMap((other) => {
    const up = inside && !other.startsWith('lab/') ? '../..' : '..'
    const from = `${up}/${inside ? other.replace('lab/', '') : other}`
    const lines = [
      `import '${from}/a'`,
      `void import('${from}')`,
      `export type { A } from '${from}/a'`,
    ]
    return lines.map((line) => ({ line, allowed: may.includes(other) }))
  })
}

/** By folder, the lines that the linter refuses: under the project's rules, in a folder of its own. */
function refused(): Map<string, string[]> {
  const place = mkdtempSync(join(tmpdir(), 'layers-'))
  try {
    copyFileSync(join(ROOT, 'biome.json'), join(place, 'biome.json'))
    const texts = new Map([...table().keys()].map((f) => [f, attempts(f).map((a) => a.line)]))
    for (const [folder, lines] of texts) {
      mkdirSync(join(place, 'www/src', folder), { recursive: true })
      writeFileSync(join(place, 'www/src', folder, 'new.ts'), `${lines.join('\n')}\n`)
    }
    const biome = join(ROOT, 'www/node_modules/@biomejs/biome/bin/biome')
    const lint = ['lint', '--only=style/noRestrictedImports', '--reporter=github']
    const { stdout } = spawnSync(
      process.execPath,
      [biome, ...lint, '--max-diagnostics=none', place],
      { cwd: place, encoding: 'utf8', maxBuffer: 1 << 26 },
    )
    const found = new Map<string, string[]>([...texts.keys()].map((folder) => [folder, []]))
    for (const [, folder = '', line] of stdout.matchAll(/www\/src\/([\w/]+)\/new\.ts,line=(\d+)/g))
      found.get(folder)?.push(texts.get(folder)?.[Number(line) - 1] ?? '?')
    return found
  } finally {
    rmSync(place, { recursive: true })
  }
}

test('the table has every folder', () => {
  expect([...table().keys()].sort()).toEqual(
    [...folders.filter((name) => name !== 'app'), ...ofLab].sort(),
  )
})

test('a path that the table names is there', () => {
  const named = ['state/lazy_parts.ts', 'app/lazy_parts.ts']
  expect(named.filter((path) => !existsSync(join(SOURCE, path)))).toEqual([])
})

test('the linter refuses what the table does not allow, lazily fetched or a mere type, and nothing else', () => {
  const all = refused()
  for (const folder of table().keys()) {
    const expected = attempts(folder).flatMap(({ line, allowed }) => (allowed ? [] : [line]))
    expect(all.get(folder)?.sort(), folder).toEqual(expected.sort())
  }
})
