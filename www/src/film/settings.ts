/** What a film of the race is made of, and which moment of the runs each of its frames shows. */
import type { PanelView } from '../model/messages'

export const RATES = [24, 30, 60] as const
export type Rate = (typeof RATES)[number]
/** What passes in the runs from picture to picture. */
export type Unit = 'iteration' | 'move'

/** Pixels. Encoders want even numbers. */
export interface FilmSize {
  width: number
  height: number
}

export const SIZES: readonly FilmSize[] = [
  { width: 1280, height: 720 },
  { width: 1920, height: 1080 },
  { width: 1080, height: 1080 },
  { width: 1080, height: 1920 },
]
export const SIDE = { least: 160, most: 3840 }
export const MOST_SECONDS = 600

/** A panel, and what its run had reached when the film was asked for: with that its copy is compared. */
export interface Filmed {
  id: number
  reached: { iteration: number; digest: string } | null
}

export interface FilmLook extends FilmSize {
  layer: PanelView['layer']
  theme: PanelView['theme']
  /** Side by side in this order. */
  panels: Filmed[]
}

export interface FilmSettings extends FilmLook {
  rate: Rate
  unit: Unit
  /** The last iteration, or so many moves from the beginning. */
  last: number
  /** Iterations or moves. */
  perSecond: number
}

/** Seconds for which the result stands still, and then stands beside the code of its link. */
export const RESULT_SECONDS = 2
export const CODE_SECONDS = 4

/** What is seen: the runs after so many iterations or moves, ants `glide` of the way through the last of these. */
export interface Moment {
  at: number
  glide: number
  /** Nothing comes after it. */
  last: boolean
  /** With the code of the link beside the result. */
  code: boolean
}

export type Pace = Pick<FilmSettings, 'rate' | 'last' | 'perSecond'>

const runFrames = ({ rate, last, perSecond }: Pace) => Math.ceil((last * rate) / perSecond) + 1

export const framesOf = (pace: Pace) =>
  runFrames(pace) + (RESULT_SECONDS + CODE_SECONDS) * pace.rate - 1

export const secondsOf = (pace: Pace) => framesOf(pace) / pace.rate

/** The speed at which a film takes so long: the inverse of `secondsOf`, to the frame. */
export function speedFor(seconds: number, { rate, last }: Omit<Pace, 'perSecond'>): number {
  const running = Math.max(1, Math.round((seconds - RESULT_SECONDS - CODE_SECONDS) * rate))
  return (last * rate) / running
}

/** Iterations are pictures as they end; between two moves ants are under way. */
export function momentOf(frame: number, settings: Pace & Pick<FilmSettings, 'unit'>): Moment {
  const { rate, last, perSecond, unit } = settings
  const passed = Math.min(last, (frame * perSecond) / rate)
  const code = frame >= runFrames(settings) + RESULT_SECONDS * rate - 1
  const at =
    unit === 'iteration' ? Math.floor(passed + 1e-9) : Math.max(0, Math.ceil(passed - 1e-9))
  const glide = unit === 'move' && at > 0 ? Math.min(1, passed - at + 1) : 1
  return { at, glide, last: passed >= last, code }
}

/** The nearest size that encoders take. */
export function evenSize({ width, height }: FilmSize): FilmSize {
  const even = (side: number) => 2 * Math.round(Math.min(SIDE.most, Math.max(SIDE.least, side)) / 2)
  return { width: even(width), height: even(height) }
}
