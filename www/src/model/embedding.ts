/** How another page embeds this one: what its address asks for, the address itself, and the HTML that holds it. */

/** What the reader may have besides the maps, in the order of docs/embedding.md. */
export const CONTROLS = ['play', 'step', 'numbers', 'layers', 'edit', 'charts', 'open'] as const
export type Control = (typeof CONTROLS)[number]

/** With `?embed` alone. */
export const USUAL_CONTROLS: readonly Control[] = ['play', 'step', 'numbers']

/** What else the address may say, and how; null: anything that `readOrigin` takes, or nothing. */
const KNOWN: Record<string, readonly string[] | null> = {
  embed: null,
  theme: ['light', 'dark'],
  lang: ['en', 'zh-CN'],
  autoplay: null,
  origin: null,
}

/** What the address asks for and is not known here, and what would be. */
export interface Unclear {
  what: string
  known: readonly string[]
}

export interface Embedding {
  controls: ReadonlySet<Control>
  /** The origin of the page around it, if it is named: the text `null` for one that has none. */
  origin: string | null
  unclear: Unclear[]
}

const isControl = (name: string): name is Control => (CONTROLS as readonly string[]).includes(name)

export function readEmbedding(query: URLSearchParams): Embedding {
  const asked = (query.get('embed') ?? '').split(',').filter((name) => name !== '')
  const controls = asked.filter(isControl)
  const origin = readOrigin(query.get('origin'))
  const unclear = [
    ...asked.flatMap((name) => (isControl(name) ? [] : [{ what: name, known: CONTROLS }])),
    ...[...query].flatMap(([name, value]) => unclearIn(name, value)),
    ...(query.has('origin') && origin === null ? [wrongOrigin(query.get('origin') ?? '')] : []),
  ]
  return { controls: new Set(controls.length > 0 ? controls : USUAL_CONTROLS), origin, unclear }
}

function unclearIn(name: string, value: string): Unclear[] {
  if (!Object.hasOwn(KNOWN, name)) return [{ what: name, known: Object.keys(KNOWN) }]
  const values = KNOWN[name]
  return values && !values.includes(value) ? [{ what: `${name}=${value}`, known: values }] : []
}

const wrongOrigin = (value: string): Unclear => ({
  what: `origin=${value}`,
  known: ['https://course.example.edu', 'null'],
})

/** As `event.origin` of a message has it; null where nothing, or nothing such, is said. */
function readOrigin(value: string | null): string | null {
  if (value === null || value === 'null') return value
  try {
    return new URL(value).origin === value ? value : null
  } catch {
    return null
  }
}

export interface Asked {
  controls?: readonly Control[]
  theme?: string | null
  lang?: string | null
  autoplay?: boolean
  origin?: string | null
}

/** `page` where Formicarium is, as one embeds it; `fragment` is `#x=…`, `#q=…` or nothing. */
export function embeddedAddress(page: string, asked: Asked, fragment = ''): string {
  const { controls = [], theme, lang, autoplay, origin } = asked
  const isUsual = controls.join() === USUAL_CONTROLS.join()
  const query = [
    isUsual || controls.length === 0 ? 'embed' : `embed=${controls.join()}`,
    ...(theme ? [`theme=${encodeURIComponent(theme)}`] : []),
    ...(lang ? [`lang=${encodeURIComponent(lang)}`] : []),
    ...(autoplay ? ['autoplay'] : []),
    ...(origin ? [`origin=${encodeURIComponent(origin)}`] : []),
  ]
  return `${page.replace(/[?#].*$/s, '')}?${query.join('&')}${fragment}`
}

const escaped = (text: string) =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;')

/** One line to paste into a page. It tells the frame whose page it is in, and nothing more: the frame answers to that page alone. */
export function frameSnippet(address: string, title: string, height: number): string {
  const attributes = {
    src: address,
    title,
    width: '100%',
    height: String(height),
    style: 'border: 0',
    loading: 'lazy',
    referrerpolicy: 'origin',
    allow: 'clipboard-write',
  }
  const text = Object.entries(attributes).map(([name, value]) => `${name}="${escaped(value)}"`)
  return `<iframe ${text.join(' ')}></iframe>`
}
