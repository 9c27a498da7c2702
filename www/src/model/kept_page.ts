/** What the page and its service worker say to each other about the copy of the page that the browser keeps. */

/** A version of the page, as `version.json` tells of it (www/version_of_page.ts). */
export interface PageVersion {
  engine: string
  /** What planners give on small questions, by planner: equal texts, equal results. */
  results: Record<string, string>
}

/** The copy: which version is in use, and a newer one that is here too and waits to be asked for. */
export interface KeptPage {
  used: PageVersion
  newer: PageVersion | null
  /** Of the newest version: the others are about as large. */
  bytes: number
}

/** `look` is answered by a KeptPage or null; the others by null once they are done. */
export type KeepRequest =
  | { ask: 'look' }
  /** Uses the newer version from the next load on, and lets go of the other. */
  | { ask: 'use-newer' }
  /** Lets go of everything. */
  | { ask: 'forget' }
