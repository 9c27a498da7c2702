/** A tracker of its own with one scenario, and the command line that judges claims by it. */
import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Scenario } from '../../www/src/model/session'

/** Names the command line tool; without it there is nothing to judge by. */
export const cli = process.env.FORMICARIUM_CLI

/** The folder of a tracker whose scenario `one` is this one. */
export function trackerOf(scenario: Scenario): string {
  const folder = mkdtempSync(join(tmpdir(), 'formicarium-tracker-'))
  mkdirSync(join(folder, 'scenarios'))
  writeFileSync(join(folder, 'scenarios/one.toml'), 'map = "../map.json"\nabout = "One."\n')
  writeFileSync(join(folder, 'map.json'), scenarioFile(scenario))
  return folder
}

/** A scenario as a file. */
function scenarioFile(scenario: Scenario): string {
  const { map: rows, ...heights } = rowsOf(scenario)
  return JSON.stringify({
    format: 'formicarium/scenario@1',
    ...scenario.spec,
    map: { rows, ...heights },
  })
}

/** Cells as rows of text and, on a terrain, heights as rows of numbers. */
export function rowsOf({ spec, cells, heights }: Scenario) {
  const row = <T>(all: ArrayLike<T>, y: number) =>
    Array.from(all).slice(y * spec.width, (y + 1) * spec.width)
  const letters = Array.from(cells, (cell) => (cell === 1 ? '@' : '.'))
  const ys = Array.from({ length: spec.height }, (_, y) => y)
  return {
    map: ys.map((y) => row(letters, y).join('')),
    // What is no number becomes null.
    ...(heights && { heights: ys.map((y) => row(heights, y)) }),
  }
}

/** What `formicarium submit` says of a claim, and its exit code. */
export function submit(folder: string, claim: string): { code: number; said: string } {
  const args = ['submit', claim, '--by', 'Ada', '--tracker', folder]
  try {
    return { code: 0, said: execFileSync(cli ?? '', args, { encoding: 'utf8', stdio: 'pipe' }) }
  } catch (error) {
    const { status, stdout, stderr } = error as { status: number; stdout: string; stderr: string }
    return { code: status, said: stdout + stderr }
  }
}
