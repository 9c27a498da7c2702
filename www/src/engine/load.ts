/**
 * Fetches and compiles the engine once; workers receive the compiled module and only instantiate it.
 *
 * There are two builds: the core, which a visitor waits for, and the whole engine with file formats and generators, which is
 * fetched when somebody first opens, saves or makes a map.
 */
import coreUrl from '@pkg/core/formicarium_bg.wasm?url'
import wholeUrl from '@pkg/formicarium_bg.wasm?url'

/** The core's compiled module. */
export const coreModule = compiledOnce(coreUrl)
/** The whole engine's compiled module. */
export const wholeModule = compiledOnce(wholeUrl)

/** A failed load is forgotten, so that the next call tries again. */
function compiledOnce(url: string): () => Promise<WebAssembly.Module> {
  let loading: Promise<WebAssembly.Module> | null = null
  return () => {
    loading ??= compile(url).catch((error: unknown) => {
      loading = null
      throw error
    })
    return loading
  }
}

async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url)
  if (!response.ok) throw new Error(`The engine could not be fetched (HTTP ${response.status}).`)
  // Static hosts that do not know application/wasm make the streaming compiler refuse; the bytes are fine all the same.
  const spare = response.clone()
  try {
    return await WebAssembly.compileStreaming(response)
  } catch {
    return WebAssembly.compile(await spare.arrayBuffer())
  }
}
