/** Asks again and again while the reader chooses: one question at a time, and of those that wait the last. */
import { useEffect, useRef, useState } from 'preact/hooks'

/** While a slider moves, not every value is asked for. */
const REST_MS = 80

export interface Latest<T> {
  /** The last one that succeeded. */
  answer: T | null
  /** Whether `answer` or `error` are about what is asked now. */
  settled: boolean
  error: unknown
}

/** `wanted` names the question; `ask` null: nothing can be asked yet. */
export function useLatest<T>(wanted: string, ask: (() => Promise<T>) | null): Latest<T> {
  const [last, setLast] = useState<{ of: string; answer: T | null; error: unknown }>({
    of: '',
    answer: null,
    error: null,
  })
  const state = useRef({ ask, wanted, busy: false, gone: false })
  Object.assign(state.current, { ask, wanted })

  useEffect(() => {
    const now = state.current
    const run = async () => {
      if (now.busy) return
      now.busy = true
      for (let done = ''; !now.gone && done !== now.wanted && now.ask; ) {
        const of = now.wanted
        const result = await now.ask().then(
          (answer) => ({ answer, error: null as unknown }),
          (error: unknown) => ({ answer: null, error }),
        )
        done = of
        if (!now.gone)
          setLast((before) => ({ of, ...result, answer: result.answer ?? before.answer }))
      }
      now.busy = false
    }
    const timer = setTimeout(run, REST_MS)
    return () => clearTimeout(timer)
  }, [wanted])
  useEffect(
    () => () => {
      state.current.gone = true
    },
    [],
  )
  const settled = last.of === wanted
  return { answer: last.answer, settled, error: settled ? last.error : null }
}
