import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Catalog } from '@pkg/formicarium'
import { expect, test } from '@playwright/test'
import { zhCNEngine } from '../../../www/src/i18n/zh_cn_engine'

const PKG = join(__dirname, '../../../pkg')

/** What the whole engine offers, asked of the engine itself. */
async function wholeCatalog(): Promise<Catalog> {
  const engine = await import(join(PKG, 'formicarium.js'))
  engine.initSync({ module: readFileSync(join(PKG, 'formicarium_bg.wasm')) })
  return engine.catalog()
}

test('everything in the catalog has a Chinese name', async () => {
  const { planners } = await wholeCatalog()
  const { planners: named, params, options, presets, components, meanings } = zhCNEngine
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
    for (const { key, kind } of planner.params) {
      look(params, 'params', [key])
      if (kind.type !== 'choice') continue
      const ids = kind.options.map(({ id }) => id)
      look(options, 'options', ids)
      // Options that are planners are told by their names.
      const told = ids.filter((id) => !(id in named))
      look((meanings as Record<string, object>)[key] ?? {}, `meanings.${key}`, told)
    }
  }
  expect([...new Set(missing)], 'add these to www/src/i18n/zh_cn_engine.ts').toEqual([])
})
