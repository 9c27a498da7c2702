/** The command line tool beside the page: what one has written, the other reads. */
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from '@playwright/test'

/** Where it is; without it the test is skipped. */
export function commandLine(): string {
  const cli = process.env.FORMICARIUM_CLI ?? ''
  test.skip(cli === '', 'FORMICARIUM_CLI does not name the command line tool')
  return cli
}

/** What it answers as JSON, in a folder that holds these files and nothing else. */
export function answered<Told>(
  cli: string,
  files: Record<string, Buffer | string>,
  args: string[],
): Told {
  const folder = mkdtempSync(join(tmpdir(), 'command-line-'))
  try {
    for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content)
    const given = [...args, '--format', 'json']
    return JSON.parse(execFileSync(cli, given, { cwd: folder, encoding: 'utf8' }))
  } finally {
    rmSync(folder, { recursive: true })
  }
}
