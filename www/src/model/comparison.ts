/** A comparison as a document, as far as the page reads it (docs/formats.md). */
import type { ScenarioSpec, ComparisonDocument as Written } from '@pkg/formicarium'

/** A map of the question: `formicarium/scenario@1`. */
export type MapOfQuestion = ScenarioSpec & Record<string, unknown>

/** Read or written here; the engine checks it when it opens it. */
export type ComparisonDocument = Omit<Written, 'maps'> & { maps: MapOfQuestion[] }

export const textOf = (document: ComparisonDocument): string => JSON.stringify(document)

/** Of a document that the engine has accepted. */
export const documentOf = (text: string): ComparisonDocument =>
  JSON.parse(text) as ComparisonDocument
