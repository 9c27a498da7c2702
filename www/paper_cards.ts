/**
 * The paper cards of docs/papers, for the page: which card tells about which planner, as the card's own "Planners:" line says.
 * Their text is fetched when somebody reads them.
 */
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import type { Plugin } from 'vite'

const FOLDER = fileURLToPath(new URL('../docs/papers', import.meta.url))
const MODULE = 'virtual:paper-cards'

export function paperCards(): Plugin {
  return {
    name: 'formicarium:paper-cards',
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : undefined),
    load: (id) => (id === `\0${MODULE}` ? `export default ${JSON.stringify(cards())}` : undefined),
  }
}

/** By planner, or planner and preset with a space between, the card's name. The first card that names one has it. */
function cards(): Record<string, string> {
  const found: Record<string, string> = {}
  for (const file of readdirSync(FOLDER).sort()) {
    if (!file.endsWith('.md')) continue
    const line = readFileSync(`${FOLDER}/${file}`, 'utf8').match(/^Planners?:(.*)$/m)?.[1] ?? ''
    for (const key of plannersOf(line)) found[key] ??= file.slice(0, -'.md'.length)
  }
  return found
}

/** From "`ship`, `ship --preset printed`": ship, and ship printed. */
function plannersOf(line: string): string[] {
  const named = line.matchAll(/`([a-z0-9-]+)(?: --preset ([\w-]+))?`/g)
  return [...named].map(([, planner, preset]) => (preset ? `${planner} ${preset}` : `${planner}`))
}
