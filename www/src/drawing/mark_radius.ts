/** How large marks are. Apart from what draws them: the page asks for it before it draws any. */
import type { PanelView } from '../model/messages'

/** Device pixels: at least as large as can be seen and grasped, even when a cell is a pixel; with several goals there is room for a number. */
export function markRadius(
  { scale, dpr }: Pick<PanelView, 'scale' | 'dpr'>,
  several: boolean,
): number {
  return Math.min(16 * dpr, Math.max((several ? 8 : 6) * dpr, 0.4 * scale))
}
