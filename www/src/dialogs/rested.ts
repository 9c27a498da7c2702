/** What is typed takes effect after a short rest, before it is committed. */
import { useEffect, useRef } from 'preact/hooks'

const REST_MS = 300

/** Hands numbers on once none has come for a moment; what is no number yet is left out. */
export function useRested(act: (value: number) => void): (value: number) => void {
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined)
  const latest = useRef(act)
  latest.current = act
  useEffect(() => () => clearTimeout(timer.current), [])
  return (value) => {
    clearTimeout(timer.current)
    if (!Number.isNaN(value)) timer.current = setTimeout(() => latest.current(value), REST_MS)
  }
}
