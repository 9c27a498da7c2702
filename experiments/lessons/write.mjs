/**
 * Writes the gallery's lessons: `node experiments/lessons/write.mjs [--cli FORMICARIUM] [--into FOLDER]`. Each question NAME.toml is
 * compared, what the answer says is held against what came out, and the session with its recorded runs is written as
 * NAME.experiment.json, the measured numbers of all as measured.json. The same engine writes the same bytes.
 */
import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { LESSONS } from './lessons.mjs'

const HERE = fileURLToPath(new URL('.', import.meta.url))
const { values: options } = parseArgs({
  options: {
    cli: { type: 'string', default: join(HERE, '../../target/release/formicarium') },
    into: { type: 'string', default: join(HERE, '../../www/lessons') },
  },
})

mkdirSync(options.into, { recursive: true })
const work = mkdtempSync(join(tmpdir(), 'formicarium-lessons-'))
try {
  const measured = {}
  for (const lesson of LESSONS) measured[lesson.id] = write(lesson)
  writeFileSync(join(options.into, 'measured.json'), `${JSON.stringify(measured, null, 2)}\n`)
} finally {
  rmSync(work, { recursive: true })
}

/** Writes the session of a lesson, and answers with its numbers. */
function write(lesson) {
  const question = asked(lesson.id)
  const outcome = outcomeOf(lesson.id, question)
  const numbers = { seeds: outcome.seeds, ...lesson.measured(outcome) }
  if (!lesson.holds(outcome))
    throw new Error(`${lesson.id}: what its answer says does not hold: ${JSON.stringify(numbers)}`)
  const session = sessionOf(lesson, question, outcome)
  writeFileSync(join(options.into, `${lesson.id}.experiment.json`), textOf(session))
  return numbers
}

/** The question with its maps. */
function asked(id) {
  const { question, maps } = JSON.parse(cli('compare', '--document', join(HERE, `${id}.toml`)))
  question.instances.forEach((instance, i) => {
    instance.file = join(work, `${id}-${instance.id}.json`)
    writeFileSync(instance.file, JSON.stringify(maps[i]))
  })
  return { ...question, maps }
}

/** What `formicarium compare` found, as the numbers of a lesson ask for it. Where no map is named, the first one is meant. */
function outcomeOf(id, question) {
  cli('compare', join(HERE, `${id}.toml`), '--out', work, '--files', 'csv,summary-json')
  const { lines } = JSON.parse(readFileSync(join(work, `${id}.summary.json`), 'utf8'))
  const table = rowsOf(readFileSync(join(work, `${id}.csv`), 'utf8'))
  const first = question.instances[0].id
  const rows = (entry, map = first) =>
    table.filter((row) => row.entry === entry && row.instance === map)
  const plans = new Map()
  return {
    seeds: question.seeds.count,
    metres: question.maps[0].resolution,
    rows,
    line: (entry, map = first) =>
      lines.find((line) => line.entry === entry && line.instance === map),
    /** In how many pairs of equal seed the first entry has the shorter path. */
    wins(better, worse, map) {
      const others = rows(worse, map)
      const shorter = (row, i) => Number(row.length) < Number(others[i].length) - 1e-9
      return rows(better, map).filter(shorter).length
    },
    /** Every run in full, with what `compare` does not keep: its history, and its order of goals. */
    plans(entry) {
      if (!plans.has(entry))
        plans.set(
          entry,
          rows(entry).map((row) => repeated(question, row)),
        )
      return plans.get(entry)
    },
  }
}

function rowsOf(csv) {
  const [head, ...lines] = csv.trim().split('\n')
  const keys = head.split(',')
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [keys[i], cell])))
}

/** A run of the comparison on the first map, in full. */
function repeated(question, { entry, seed, digest }) {
  const run = plan(question, entry, seed)
  if (run.digest !== digest) throw new Error(`${entry}, seed ${seed}: two digests`)
  return run
}

function plan(question, entry, seed) {
  const { planner, preset, set = {} } = entryOf(question, entry)
  const values = Object.entries(set).flatMap(([key, value]) => ['--set', `${key}=${value}`])
  const named = preset ? ['--preset', preset] : []
  const map = question.instances[0].file
  const args = ['plan', map, '--planner', planner, ...named, ...values]
  return JSON.parse(cli(...args, '--seed', String(seed), '--format', 'json'))
}

function entryOf({ entries }, id) {
  return entries.find((entry) => entry.id === id)
}

/** `formicarium/experiment@1`: docs/formats.md. Titles and notes are the reader's language's, and so not in it. */
function sessionOf({ race, lesson }, question, outcome) {
  const { format: _, map, ...scenario } = question.maps[0]
  return {
    format: 'formicarium/experiment@1',
    engine: cli('--version').trim().split(' ')[1],
    scenario,
    panels: race.entries.map((entry) => panelOf(question, outcome.rows(entry)[0])),
    seed: question.seeds.from,
    sync: race.sync,
    speed: race.speed,
    layer: 'trail',
    lesson,
    map: map.rows,
    ...(map.heights && { heights: map.heights }),
  }
}

/** An entry as a panel, with its run to the end as it is in the comparison. */
function panelOf(question, row) {
  const { planner, preset = null, set = {} } = entryOf(question, row.entry)
  const { effort, status, length, digest } = repeated(question, row)
  const result = { iterations: effort.iterations, status, length, digest }
  return { planner, preset, params: { ...presetValues(planner, preset), ...set }, result }
}

/** A session has every value that differs from the defaults, whether or not a preset names it. */
function presetValues(planner, preset) {
  const { planners } = JSON.parse(cli('catalog', '--json'))
  const { presets } = planners.find(({ id }) => id === planner)
  return presets.find(({ name }) => name === preset)?.values ?? {}
}

/** JSON with a line for each field, each panel, and each row of the map. */
function textOf(session) {
  const lists = ['panels', 'map', 'heights']
  const fields = Object.entries(session).map(([key, value]) => {
    const rows = lists.includes(key) && value.map((row) => `    ${JSON.stringify(row)}`)
    const text = rows ? `[\n${rows.join(',\n')}\n  ]` : JSON.stringify(value)
    return `  "${key}": ${text}`
  })
  return `{\n${fields.join(',\n')}\n}\n`
}

/** What the command line prints; a run without a path is an answer like any other. */
function cli(...args) {
  try {
    return execFileSync(options.cli, args, { encoding: 'utf8', stdio: 'pipe', maxBuffer: 1 << 26 })
  } catch (error) {
    if (error.status === 1 && error.stdout) return error.stdout
    throw error
  }
}
