/** Names of maps that `formicarium generate` has made, as the papers' questions have them. */
import { t } from '../i18n'
import { generators } from '../model/facts'

/** Generator, size and seed: `blocks-20x20-seed3`. */
const MADE = /^([a-z]+)-(\d+)x(\d+)-seed(\d+)$/

/** In the reader's language; null for any other name. */
export function madeMapName(name: string): string | null {
  const [, id, width, height, seed] = MADE.exec(name) ?? []
  const made = generators.find((generator) => generator.id === id)
  if (!made) return null
  return t('maps.generatedName', {
    kind: `${t(`maps.kind.${made.id}`)} ${width} × ${height}`,
    seed,
  })
}
