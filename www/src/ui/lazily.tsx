/** Parts of the page that most visits do without: fetched when they are first shown. */
import { type Signal, signal } from '@preact/signals'
import type { ComponentType } from 'preact'
import { useEffect } from 'preact/hooks'
import { notifyError } from '../state'

/**
 * Stands for a component; nothing, or `Meanwhile`, is there until it has been fetched. A failed fetch is said, and tried again when
 * shown anew.
 */
export function lazily<P extends object>(
  fetch: () => Promise<ComponentType<P>>,
  Meanwhile?: ComponentType,
): ComponentType<P> {
  const fetched: Signal<ComponentType<P> | null> = signal(null)
  return (props: P) => {
    useEffect(() => {
      if (fetched.peek()) return
      fetch().then((component) => {
        fetched.value = component
      }, notifyError)
    }, [])
    const Component = fetched.value
    if (!Component) return Meanwhile ? <Meanwhile /> : null
    return <Component {...props} />
  }
}
