/** The texts with which the engine's readers refuse a file, from its source. */

const LITERAL = /r#"([\s\S]*?)"#|"((?:[^"\\]|\\[\s\S])*)"/
const CALLS = /(?:(?:FormatError|Self)::(?:syntax|field)|\bfield_error)\(/g
/** Texts that are given a name before they are passed. */
const NAMED =
  /(?:let (?:what|expected|of_this|form) =|const (?:EXPECTED|ALLOWED|FIELDS|NAMES|FORMATS|TOO_LARGE): &str =)\s*(?:if [^{]*\{\s*)?(?:format!\(\s*)?/g

const at = (pattern: RegExp, source: string, index: number) => {
  const sticky = new RegExp(pattern.source, 'y')
  sticky.lastIndex = index
  return sticky.exec(source)
}

/** A literal's text; what it is filled with differs from case to case. */
const plain = ([, raw, escaped]: RegExpExecArray) =>
  (raw ?? (escaped ?? '').replace(/\\\n\s*/g, '').replaceAll('\\"', '"')).replace(
    /\{[a-z_A-Z]*(?::[^{}]*)?\}/g,
    '{}',
  )

/** The arguments of a call, from behind its bracket on. */
function argumentsOf(source: string, start: number): string[] {
  const all = ['']
  for (let depth = 1, i = start; depth > 0 && i < source.length; ) {
    const text = at(LITERAL, source, i)?.[0] ?? source.charAt(i)
    if (text === '(' || text === '[' || text === '{') depth++
    if (text === ')' || text === ']' || text === '}') depth--
    if (text === ',' && depth === 1) all.push('')
    else all[all.length - 1] += text
    i += text.length
  }
  return all.map((text) => text.trim())
}

const literalOf = (argument: string) => {
  const literal = at(LITERAL, argument.replace(/^format!\(\s*/, ''), 0)
  return literal ? [plain(literal)] : []
}

/** Every text that is passed as what is wrong, or as what is expected. */
export function refusals(source: string): string[] {
  const passed = [...source.matchAll(CALLS)].flatMap((call) => {
    const all = argumentsOf(source, call.index + call[0].length)
    return (call[0] === 'field_error(' ? all : all.slice(1)).flatMap(literalOf)
  })
  const named = [...source.matchAll(NAMED)].flatMap(({ index, 0: { length } }) => {
    const literal = at(LITERAL, source, index + length)
    return literal ? [plain(literal)] : []
  })
  return [...new Set([...passed, ...named])]
}
