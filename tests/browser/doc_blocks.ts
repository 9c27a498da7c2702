/** Blocks of code in a page of docs/, run as they stand. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'

const VALUE = /^(?<code>\S.*\S)\s+\/\/ → (?<value>.+)$/

export const docText = (name: string) => readFileSync(join(__dirname, '../../docs', name), 'utf8')

export const blocksOf = (text: string, language: string): string[] =>
  [...text.matchAll(new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\`$`, 'gm'))].map(
    ([, code = '']) => code,
  )

/** Lines that end in a value are compared with it; names live on from block to block. It gives what was said and what should be. */
export function asScript(blocks: string[]): { code: string; values: number } {
  let values = 0
  const lines = blocks
    .join('\n')
    .split('\n')
    .map((line) => {
      const { code, value } = VALUE.exec(line)?.groups ?? {}
      if (code === undefined) return line
      values++
      return `told.push([${JSON.stringify(code)}, ${code}, ${value}]);`
    })
  const code = `(async () => { const told = []\n${lines.join('\n')}\nreturn told })()`
  return { code, values }
}
