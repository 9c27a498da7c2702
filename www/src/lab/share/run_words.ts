/** A run in words: where it stands in the question, and what its row says. */
import { t } from '../../i18n/lab'
import { shownComparison } from '../store/shown_comparison'
import { precise } from '../words/numbers'

/** What is read of a row, which the engine writes. */
interface Row {
  found: { length: number } | null
}

/** Names of map and entry, and the seed. */
export function namesOfRun(run: { instance: number; entry: number; seed: number }) {
  const now = shownComparison.peek()
  const { instances = [], entries = [] } = now?.question ?? {}
  return {
    map: now?.maps[run.instance]?.name || instances[run.instance]?.id || '',
    entry: entries[run.entry]?.label ?? '',
    seed: run.seed,
  }
}

/** What two rows of one run say where they differ: the length of the path, else the first field that is another. */
export function differing(said: string, came: string): [string, string] {
  const rows = [said, came].map((row) => JSON.parse(row) as Row) as [Row, Row]
  const lengths = rows.map(({ found }) => found?.length ?? null)
  if (lengths[0] !== lengths[1])
    return lengths.map((length) =>
      length === null ? t('lab.class.noPath') : t('lab.class.length', { value: precise(length) }),
    ) as [string, string]
  const [first, second] = rows.map(fieldsOf) as [Map<string, string>, Map<string, string>]
  const field = [...first.keys()].find((key) => first.get(key) !== second.get(key)) ?? ''
  const words = (value = '–') => t('lab.class.differsIn', { field, value })
  return [words(first.get(field)), words(second.get(field))]
}

/** All that a row tells, by dotted names. */
function fieldsOf(row: unknown): Map<string, string> {
  const fields = new Map<string, string>()
  const walk = (value: unknown, path: string) => {
    if (typeof value !== 'object' || value === null) fields.set(path, String(value))
    else
      for (const [key, inner] of Object.entries(value)) walk(inner, path ? `${path}.${key}` : key)
  }
  walk(row, '')
  return fields
}
