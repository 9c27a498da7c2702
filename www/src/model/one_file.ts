/** The page as one file (docs/one_file.md): what its loader has unpacked before the page began. */

/** What the loader leaves for the page. */
export interface OneFile {
  /** The whole file's text, as it was opened. */
  html: string
  title: string
  /** What it carries: the text of a session or comparison, or a link; empty in a page that carries nothing. */
  carried: string
  /** The address of the hosted page that it was saved from; empty where there is none. */
  from: string
  /** Workers and the engine, by name. */
  parts: Map<string, Uint8Array<ArrayBuffer>>
}

declare global {
  var formicariumFile: OneFile | undefined
}

/** Null where the page came from a host, with its parts beside it. */
export const oneFile = (): OneFile | null => globalThis.formicariumFile ?? null

const addresses = new Map<string, string>()

/** An address of a part, for as long as the page is open. */
export function partAddress(name: string, type: string): string {
  const part = oneFile()?.parts.get(name)
  if (!part) throw new Error(`the file has no part ${name}`)
  const address = addresses.get(name) ?? URL.createObjectURL(new Blob([part], { type }))
  addresses.set(name, address)
  return address
}
