/** Names that files, entries and maps go by. */

const LONGEST = 60

/** Of a title, what every file system takes as it is. */
export function fileStem(title: string): string {
  return joined(title.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, '-')) || 'comparison'
}

/** Small letters, digits and hyphens, told apart from those that are taken. */
export function uniqueId(wanted: string, taken: Iterable<string>): string {
  const all = new Set(taken)
  const plain = wanted.normalize('NFKD').toLowerCase()
  const stem = joined(plain.replace(/[^a-z0-9]+/g, '-')) || 'map'
  let id = stem
  for (let number = 2; all.has(id); number++) id = `${stem}-${number}`
  return id
}

/** Of something the browser keeps. `crypto.randomUUID` is for secure pages alone. */
export function newId(): string {
  const random = crypto.getRandomValues(new Uint32Array(2))
  return `${Date.now().toString(36)}-${[...random].map((part) => part.toString(36)).join('')}`
}

const joined = (words: string) => words.replace(/^-+/, '').slice(0, LONGEST).replace(/-+$/, '')
