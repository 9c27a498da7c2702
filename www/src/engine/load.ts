/** Fetches and compiles the engine once; workers receive the compiled module and only instantiate it. */
import wasmUrl from '@pkg/formicarium_bg.wasm?url'

let loading: Promise<WebAssembly.Module> | null = null

/** The engine's compiled module. A failed load is forgotten, so that the next call tries again. */
export function engineModule(): Promise<WebAssembly.Module> {
  loading ??= compile().catch((error: unknown) => {
    loading = null
    throw error
  })
  return loading
}

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmUrl)
  if (!response.ok) throw new Error(`The engine could not be fetched (HTTP ${response.status}).`)
  // Static hosts that do not know application/wasm make the streaming compiler refuse; the bytes are fine all the same.
  const spare = response.clone()
  try {
    return await WebAssembly.compileStreaming(response)
  } catch {
    return WebAssembly.compile(await spare.arrayBuffer())
  }
}
