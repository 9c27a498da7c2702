/** Page object of a class that computes a comparison: who shares it out, who does a share, who collects. */

import { execFileSync } from 'node:child_process'
import { readFile } from 'node:fs/promises'
import { type Browser, type Download, expect } from '@playwright/test'
import { encodeDocument, PREFIX } from '../../www/src/share/comparison_link'
import { ComparisonPage, documentText } from './comparison_page'
import { dropFiles } from './dropped_files'

/** One map, two entries, five seeds. */
export const DOCUMENT = documentText({
  entries: [
    { id: 'ants', planner: 'ant-system', set: { iterations: 10, ants: 5 } },
    { id: 'ranks', planner: 'rank-based-ant-system', set: { iterations: 10, ants: 5 } },
  ],
  seeds: 5,
})
export const RUNS = 10

/** A file as it is dropped or saved. */
export type Named = [name: string, content: string]

export class ClassPage extends ComparisonPage {
  /** A page of its own, which shares nothing with others, at an address. */
  static async at(browser: Browser, address: string): Promise<ClassPage> {
    const page = await (await browser.newContext()).newPage()
    await page.goto(address)
    return new ClassPage(page)
  }

  /** The comparison without runs. */
  async openQuestion(document = DOCUMENT): Promise<void> {
    await this.page.goto('about:blank')
    await this.page.goto(`./${PREFIX}${await encodeDocument(document)}`)
    await expect(this.page.getByTestId('run-bar')).toBeVisible()
  }

  /** Shares it out, and gives the one link for all. */
  async shareOut(shares: number): Promise<string> {
    await this.page.getByTestId('lab-share').click()
    await this.page.getByTestId('lab-share-class').click()
    await this.page.getByTestId('class-shares').fill(String(shares))
    const link = this.page.getByTestId('class-link')
    await expect(link).toHaveValue(new RegExp(`&share=\\?/${shares}$`))
    return link.inputValue()
  }

  async leaveDialog(): Promise<void> {
    await this.page.keyboard.press('Escape')
    await expect(this.page.getByRole('dialog')).toHaveCount(0)
  }

  /** Does the share that the address named, and saves it. */
  async doShare(): Promise<Named> {
    await this.page.getByTestId('share-start').click()
    await this.stage('done')
    return this.saved('share-save')
  }

  stage(stage: 'choosing' | 'ready' | 'begun' | 'done'): Promise<void> {
    return expect(this.page.getByTestId('share-card')).toHaveAttribute('data-stage', stage)
  }

  async download(testId: string): Promise<Download> {
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.getByTestId(testId).click(),
    ])
    return download
  }

  async saved(testId: string): Promise<Named> {
    const download = await this.download(testId)
    return [download.suggestedFilename(), await readFile(await download.path(), 'utf8')]
  }

  /** Drops files together anywhere on the page. */
  async dropFiles(...files: [name: string, content: string | Buffer][]): Promise<void> {
    await dropFiles(this.page, 'body', files)
  }

  /** The states of the shares, in their order. */
  states(): Promise<(string | null)[]> {
    return this.page
      .getByTestId('class-share')
      .evaluateAll((rows) => rows.map((row) => row.getAttribute('data-state')))
  }

  get refused() {
    return this.page.getByTestId('class-refused')
  }

  resultFile(kind: 'csv' | 'json'): Promise<string> {
    return this.page.evaluate((kind) => window.formicarium.resultFile(kind), kind)
  }
}

/** The engine's check sum over a line's body: FNV-1a of 64 bits over its version and the body. */
function checkSum(engine: string, body: string): string {
  let state = 0xcbf29ce484222325n
  for (const byte of Buffer.from(engine + body))
    state = BigInt.asUintN(64, (state ^ BigInt(byte)) * 0x100000001b3n)
  return state.toString(16).padStart(16, '0')
}

/** A journal with the row of one of its lines changed, and the check sum made right. */
export function forged(journal: string, line: number, change: (row: string) => string): string {
  const lines = journal.split('\n')
  const { engine } = JSON.parse(lines[0] ?? '')
  const body = lines[line - 1]?.replace(/,"check":"[0-9a-f]{16}"\}$/, '') ?? ''
  expect(lines[line - 1]).toBe(`${body},"check":"${checkSum(engine, body)}"}`)
  const other = change(body)
  expect(other).not.toBe(body)
  lines[line - 1] = `${other},"check":"${checkSum(engine, other)}"}`
  return lines.join('\n')
}

/** Another length of the path than the run has found. */
export const longer = (body: string) =>
  body.replace(/"length":(\d)/, (_, digit) => `"length":${digit === '9' ? 8 : Number(digit) + 1}`)

/** The command line, in a folder; null where nobody has built it. */
export function commandLine(folder: string): ((...args: string[]) => string) | null {
  const cli = process.env.FORMICARIUM_CLI
  if (!cli) return null
  return (...args) => execFileSync(cli, args, { cwd: folder, encoding: 'utf8' })
}
