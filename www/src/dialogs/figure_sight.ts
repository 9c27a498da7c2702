/** How much of a figure is seen: fitted, or enlarged and scrolled. */
import type { Shown } from '@pkg/formicarium'
import type { RefObject } from 'preact'
import { useEffect, useState } from 'preact/hooks'
import type { Sight } from './figure_paint'

/** Times the fitted size. */
export const ZOOMS = [1, 1.5, 2, 3, 4, 6, 8, 12, 16]
/** CSS pixels around the picture, for the handles. */
const MARGIN = 14

interface Scrolled {
  sight: Sight
  /** CSS pixels of all of it. */
  whole: { width: number; height: number }
}

/** `zoom` is an index of ZOOMS. */
export function useSight(
  scroller: RefObject<HTMLDivElement | null>,
  picture: Shown | null,
  zoom: number,
): Scrolled {
  const [{ width, height, left, top }, setView] = useState({ width: 1, height: 1, left: 0, top: 0 })
  useEffect(() => {
    const element = scroller.current
    if (!element) return
    const look = () =>
      setView({
        width: element.clientWidth,
        height: element.clientHeight,
        left: element.scrollLeft,
        top: element.scrollTop,
      })
    const observer = new ResizeObserver(look)
    observer.observe(element)
    element.addEventListener('scroll', look)
    return () => {
      observer.disconnect()
      element.removeEventListener('scroll', look)
    }
  }, [])
  const [wide, high] = [picture?.width ?? 1, picture?.height ?? 1]
  const fit = Math.min((width - 2 * MARGIN) / wide, (height - 2 * MARGIN) / high)
  const scale = Math.max(1e-3, fit) * (ZOOMS[zoom] ?? 1)
  const whole = {
    width: Math.max(width, Math.floor(wide * scale + 2 * MARGIN)),
    height: Math.max(height, Math.floor(high * scale + 2 * MARGIN)),
  }
  const offset = [
    (whole.width - wide * scale) / 2 - left,
    (whole.height - high * scale) / 2 - top,
  ] as const
  return { sight: { width, height, scale, offset }, whole }
}
