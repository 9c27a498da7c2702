/** Reads a map again and again while the reader chooses: one reading at a time, and of those that wait the last. */
import type { Imported, ReadOptions } from '@pkg/formicarium'
import { useEffect, useRef, useState } from 'preact/hooks'
import type { MapFile } from '../state'
import { readMap } from '../state/open_files'

/** While a slider moves, not every value is read. */
const REST_MS = 80

export interface Reading {
  /** The last one that succeeded. */
  map: Imported | null
  /** Whether `map` or `error` are about what is asked now. */
  settled: boolean
  error: unknown
}

/** `options` null: nothing can be read yet. */
export function useReading(file: MapFile, options: ReadOptions | null): Reading {
  const wanted = JSON.stringify(options)
  const [reading, setReading] = useState<{ of: string; map: Imported | null; error: unknown }>({
    of: '',
    map: null,
    error: null,
  })
  const state = useRef({ file, options, wanted, busy: false, gone: false })
  Object.assign(state.current, { file, options, wanted })

  useEffect(() => {
    const now = state.current
    const read = async () => {
      if (now.busy) return
      now.busy = true
      for (let done = ''; !now.gone && done !== now.wanted && now.options; ) {
        const of = now.wanted
        const result = await readMap(now.file, now.options).then(
          (map) => ({ map, error: null as unknown }),
          (error: unknown) => ({ map: null, error }),
        )
        done = of
        if (!now.gone) setReading((before) => ({ of, ...result, map: result.map ?? before.map }))
      }
      now.busy = false
    }
    const timer = setTimeout(read, REST_MS)
    return () => clearTimeout(timer)
  }, [wanted, file])
  useEffect(
    () => () => {
      state.current.gone = true
    },
    [],
  )
  const settled = reading.of === wanted
  return { map: reading.map, settled, error: settled ? reading.error : null }
}
