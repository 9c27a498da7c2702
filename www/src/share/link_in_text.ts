/** The fragment of a link that stands in a text. */

const LINK = /#(?:[xq]|lesson)=[\w-]+(?:&[\w?/%=]+)?/

/** Null where there is none. A file may contain a link, so only text that is no JSON is searched for one. */
export const linkIn = (text: string): string | null =>
  text.trimStart().startsWith('{') ? null : (LINK.exec(text)?.[0] ?? null)
