/** Names of files, ids of entries, maps and stored things. */

const LONGEST = 60

/** A title as a file name that every file system takes. */
export function fileStem(title: string): string {
  return joined(title.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, '-')) || 'comparison'
}

/** An id of lower-case letters, digits and hyphens that is not taken yet. */
export function uniqueId(wanted: string, taken: Iterable<string>): string {
  const all = new Set(taken)
  const plain = wanted.normalize('NFKD').toLowerCase()
  const stem = joined(plain.replace(/[^a-z0-9]+/g, '-')) || 'map'
  let id = stem
  for (let number = 2; all.has(id); number++) id = `${stem}-${number}`
  return id
}

/** An id for something stored. `crypto.randomUUID` exists on secure pages only. */
export function newId(): string {
  const random = crypto.getRandomValues(new Uint32Array(2))
  return `${Date.now().toString(36)}-${[...random].map((part) => part.toString(36)).join('')}`
}

const joined = (words: string) => words.replace(/^-+/, '').slice(0, LONGEST).replace(/-+$/, '')
