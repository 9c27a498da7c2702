/**
 * The papers' questions of experiments/*.toml, for the page: each with its maps as one document (`formicarium/comparison@1`), as
 * `formicarium compare` makes it of the same files. What they are about comes with the list; a document is fetched when somebody runs it.
 */
import { readdirSync, readFileSync } from 'node:fs'
import { basename } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { ComparisonDocument, Formats, Question } from '@pkg/formicarium'
import { parse } from 'smol-toml'
import type { Plugin } from 'vite'

const FOLDER = fileURLToPath(new URL('../experiments', import.meta.url))
const CARDS = fileURLToPath(new URL('../docs/papers', import.meta.url))
const LIST = 'virtual:paper-questions'
const DOCUMENT = 'virtual:paper-question/'

const FACTS = fileURLToPath(new URL('../pkg/facts.json', import.meta.url))

/** What the engine knows, as the page reads it. */
const formats = (): Formats => JSON.parse(readFileSync(FACTS, 'utf8')).formats

export function paperQuestions(): Plugin {
  return {
    name: 'formicarium:paper-questions',
    resolveId: (id) => (id === LIST || id.startsWith(DOCUMENT) ? `\0${id}` : undefined),
    load(id) {
      if (id === `\0${LIST}`) return listModule()
      if (!id.startsWith(`\0${DOCUMENT}`)) return undefined
      const name = id.slice(DOCUMENT.length + 1)
      this.addWatchFile(`${FOLDER}/${name}.toml`)
      return `export default ${JSON.stringify(documentOf(name))}`
    },
  }
}

const names = () =>
  readdirSync(FOLDER)
    .filter((file) => file.endsWith('.toml'))
    .map((file) => file.slice(0, -'.toml'.length))
    .sort()

const questionOf = (name: string) =>
  parse(readFileSync(`${FOLDER}/${name}.toml`, 'utf8')) as unknown as Question

/** An import written out for each, so that each becomes a file of its own. */
function listModule(): string {
  const rows = names().map((name) => {
    const fetch = `() => import(${JSON.stringify(DOCUMENT + name)}).then((m) => m.default)`
    return `{ ...${JSON.stringify(listed(name))}, document: ${fetch} }`
  })
  return `export default [${rows.join(',\n')}]`
}

function listed(name: string) {
  const { title, paper = '', seeds, instances, entries } = questionOf(name)
  return {
    id: name,
    title,
    paper,
    seeds: seeds.count,
    maps: instances.map(({ map }) => basename(map, '.json')),
    entries: entries.length,
    runs: entries.filter(({ planner }) => planner !== undefined).length * instances.length,
    moves: movesOf(name, seeds.count),
    onTerrain: instances.every(({ map }) => 'terrain' in mapOf(map)),
    card: cardOf(name),
  }
}

/** The card of a paper is called like its question, or like the beginning of one of several. */
function cardOf(name: string): string | null {
  const cards = readdirSync(CARDS).map((file) => basename(file, '.md'))
  return cards.find((card) => name === card || name.startsWith(`${card}-`)) ?? null
}

/** Ant moves of all runs with one seed, as recorded: how long it takes is reckoned from them. */
function movesOf(name: string, seeds: number): number {
  const [head, ...rows] = readFileSync(`${FOLDER}/records/${name}.csv`, 'utf8').trim().split('\n')
  const at = head?.split(',').indexOf('ant_moves') ?? -1
  const sum = rows.reduce((all, row) => all + Number(row.split(',')[at] ?? 0), 0)
  return Math.round(sum / seeds)
}

const mapOf = (file: string) => JSON.parse(readFileSync(`${FOLDER}/${file}`, 'utf8'))

/** Maps go by their file's name, as on the command line: folders are a machine's. */
function documentOf(name: string): string {
  const question = questionOf(name)
  const maps = question.instances.map(({ map }) => mapOf(map))
  const instances = question.instances.map((one) => ({ ...one, map: basename(one.map) }))
  const document: ComparisonDocument = {
    format: formats().comparison,
    question: { ...question, instances },
    maps,
  }
  return JSON.stringify(document)
}
