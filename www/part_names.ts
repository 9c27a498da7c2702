/** The files of the page's lazy parts, as scripts name them (parts_of_page.ts). */

/** An import and the list of its files: empty, or places of the table that stands at the head of the script. */
const IMPORT =
  /import\((["'`])\.\/([^"'`]+)\1\)((?:(?!import\().)*?),(?:\[\]|void 0|__vite__mapDeps\(\[([\d,]*)\]\)),(import\.meta\.url\))/gs
const TABLE = /(m\.f=\[)([^\]]*)(\])/

/** The scripts of a bundle, and those that each of them imports as it begins. */
type Imports = (file: string) => string[]

/** The code of a script with every file of each part that it fetches: those that it has itself are there. */
export function withAllNames(code: string, name: string, imports: Imports): string {
  const table = (TABLE.exec(code)?.[2] ?? '').split(',').filter((entry) => entry !== '')
  const here = allOf(name, imports)
  const placeOf = (file: string) => {
    const entry = JSON.stringify(`./${file}`)
    return table.includes(entry) ? table.indexOf(entry) : table.push(entry) - 1
  }
  const complete = (
    all: string,
    quote: string,
    file: string,
    between: string,
    places: string | undefined,
    end: string,
  ) => {
    const needed = [...allOf(file, imports)].filter((each) => !here.has(each))
    const start = `import(${quote}./${file}${quote})${between},`
    if (places === undefined)
      return `${start}[${needed.map((each) => `${quote}./${each}${quote}`)}],${end}`
    const known = places
      .split(',')
      .filter((place) => place !== '')
      .map(Number)
    const missing = needed.map(placeOf).filter((place) => !known.includes(place))
    return missing.length === 0
      ? all
      : `${start}__vite__mapDeps([${[...known, ...missing]}]),${end}`
  }
  const done = code.replace(IMPORT, complete)
  return done.replace(TABLE, (_all, start, _entries, end) => `${start}${table.join(',')}${end}`)
}

/** A script and all that it cannot begin without. */
function allOf(file: string, imports: Imports, found = new Set<string>()): Set<string> {
  if (!found.has(file)) {
    found.add(file)
    for (const next of imports(file)) allOf(next, imports, found)
  }
  return found
}
