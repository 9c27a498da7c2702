/**
 * Fetches a part of the page: takes the place of Vite's own helper (www/parts_of_page.ts), which stands around each `import()`.
 *
 * In Firefox and WebKit an `import()` that failed once fails until the page is loaded anew. So all files of a part are fetched before,
 * by a way that can be gone again, and imported from the browser's cache.
 */
import { fetchOwn, refuse } from './files_of_page'

const here = new Map<string, Promise<void>>()

/** `files`: the part's own scripts and styles, as addresses from `importer`. Throws an EngineError. */
export async function fetchPart<Part>(
  load: () => Promise<Part>,
  files: string[],
  importer: string,
): Promise<Part> {
  await Promise.all(files.map((file) => once(new URL(file, importer).href)))
  return load()
}

/** A failure is forgotten, so that the next call tries again. */
function once(href: string): Promise<void> {
  let coming = here.get(href)
  if (!coming) {
    coming = (isStyle(href) ? style(href) : script(href)).catch((error: unknown) => {
      here.delete(href)
      throw error
    })
    here.set(href, coming)
  }
  return coming
}

const isStyle = (href: string) => new URL(href).pathname.endsWith('.css')

/** To its end: only what is whole is taken from the cache. */
async function script(href: string): Promise<void> {
  if (isLoaded(href)) return
  await (await fetchOwn(href)).arrayBuffer().catch(refuse)
}

async function style(href: string): Promise<void> {
  if (isLoaded(href)) return
  await script(href)
  const link = document.createElement('link')
  link.rel = 'stylesheet'
  link.href = href
  await new Promise((resolve, reject) => {
    link.onload = resolve
    link.onerror = reject
    document.head.append(link)
  }).catch(() => {
    link.remove()
    refuse()
  })
}

/** The page itself names what it begins with. */
const isLoaded = (href: string) =>
  [
    ...document.querySelectorAll<HTMLLinkElement & HTMLScriptElement>('link[href], script[src]'),
  ].some((element) => (element.href || element.src) === href)
