/** Slider positions for ranges of any width: even for narrow ones, finer near the low end for wide ones. */
import type { ParamKind } from '@pkg/formicarium'

type Ranged = Extract<ParamKind, { min: number }>

export const SLIDER_STEPS = 200
/** Wider ranges than this are bent: nobody needs 970 of 1000 ants exactly. */
const EVEN_WIDTH = 20
const BEND = 3

export function toSlider(value: number, kind: Ranged): number {
  const share = (value - kind.min) / (kind.max - kind.min)
  return Math.round(Math.max(0, Math.min(1, share)) ** (1 / power(kind)) * SLIDER_STEPS)
}

export function fromSlider(position: number, kind: Ranged): number {
  if (position >= SLIDER_STEPS) return kind.max
  const value = kind.min + (position / SLIDER_STEPS) ** power(kind) * (kind.max - kind.min)
  return kind.type === 'integer' ? Math.round(value) : Number(value.toPrecision(3))
}

function power({ min, max }: Ranged): number {
  return max - min > EVEN_WIDTH ? BEND : 1
}
