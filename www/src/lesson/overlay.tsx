/** A drawing over one panel's map, which pointers go through. */
import type { ComponentChildren } from 'preact'
import type { CanvasSize } from '../stage/panel_view'

interface OverlayProps {
  size: CanvasSize
  class: string
  testId: string
  colour?: string
  children: ComponentChildren
}

export function Overlay({ size, class: name, testId, colour, children }: OverlayProps) {
  return (
    <svg
      class={`lesson-overlay ${name}`}
      aria-hidden="true"
      width={size.width / size.dpr}
      height={size.height / size.dpr}
      style={colour ? { color: colour } : undefined}
      data-testid={testId}
    >
      {children}
    </svg>
  )
}
