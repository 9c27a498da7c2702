/** A hint that keeps its place while there is nothing to say, so that nothing below it moves when it comes. */
import type { ComponentChildren } from 'preact'

interface ReservedProps {
  shown: boolean
  testId?: string
  children: ComponentChildren
}

export function Reserved({ shown, testId, children }: ReservedProps) {
  return (
    <p class={shown ? 'hint' : 'hint reserved'} aria-hidden={!shown} data-testid={testId}>
      {children}
    </p>
  )
}
