/** The headers that docs/hosting.md asks of a host. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { DIST } from './static_host'

/** As the docs have them, with the hashes of the built page. */
export function headersOfDocs(): Record<string, string> {
  const docs = readFileSync(join(__dirname, '../../docs/hosting.md'), 'utf8')
  const [, block = ''] = /```headers\n([\s\S]*?)```/.exec(docs) ?? []
  const page = readFileSync(join(DIST, 'index.html'), 'utf8').replaceAll('&#39;', "'")
  const hashes = new Set(page.match(/'sha256-[^']*'/g))
  return Object.fromEntries(
    block
      .trim()
      .split('\n')
      .map((line) => [
        line.slice(0, line.indexOf(': ')),
        line.slice(line.indexOf(': ') + 2).replace("'sha256-…'", [...hashes].join(' ')),
      ]),
  )
}
