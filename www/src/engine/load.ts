/** Fetches and compiles each build of the engine once (see builds.ts); workers receive the compiled module and only instantiate it. */
import coreUrl from '@pkg/core/formicarium_bg.wasm?url'
import wholeUrl from '@pkg/formicarium_bg.wasm?url'
import type { Build } from './builds'
import { fetchOwn, refuse } from './files_of_page'

const core = compiledOnce(coreUrl)

/** The compiled module of a build. The page as one file has the whole engine in the place of the core. */
export const modules: Record<Build, () => Promise<WebAssembly.Module>> = {
  core,
  whole: wholeUrl === coreUrl ? core : compiledOnce(wholeUrl),
}

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
  const response = await fetchOwn(url)
  // Static hosts that do not know application/wasm make the streaming compiler refuse; the bytes are fine all the same.
  const spare = response.clone()
  try {
    return await WebAssembly.compileStreaming(response)
  } catch {
    return WebAssembly.compile(await spare.arrayBuffer().catch(refuse))
  }
}
