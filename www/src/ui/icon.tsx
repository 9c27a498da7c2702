import type { IconNode } from 'lucide'
import { h } from 'preact'

/** An icon is decoration: the control around it carries the words. */
export function Icon({ icon, size = 18 }: { icon: IconNode; size?: number }) {
  return (
    <svg class="icon" width={size} height={size} viewBox="0 0 24 24" aria-hidden="true">
      {icon.map(([tag, attributes]) => h(tag, attributes))}
    </svg>
  )
}
