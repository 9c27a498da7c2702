/** Where the eye is over a terrain: one for all panels, so that they turn together. */
import { signal } from '@preact/signals'

export interface Eye {
  /** Radians; 0 looks to the north, growing values turn the map counterclockwise. */
  azimuth: number
  /** Radians above the horizon. */
  elevation: number
  /** 1 shows the whole map. */
  zoom: number
  /** What is looked at, as a fraction of the map's width and height. */
  centreX: number
  centreY: number
}

const HOME: Eye = { azimuth: -0.45, elevation: 0.72, zoom: 1, centreX: 0.5, centreY: 0.5 }
const LOWEST = 0.12
const HIGHEST = 1.55
const MOST_ZOOM = 24
const LEAST_ZOOM = 0.5

export const eye = signal<Eye>(HOME)

export function resetEye(): void {
  eye.value = HOME
}

/** Radians around and up. */
export function orbit(around: number, up: number): void {
  const now = eye.peek()
  const elevation = Math.min(HIGHEST, Math.max(LOWEST, now.elevation + up))
  eye.value = { ...now, azimuth: (now.azimuth + around) % (2 * Math.PI), elevation }
}

export function zoomEye(factor: number): void {
  const now = eye.peek()
  eye.value = { ...now, zoom: Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, now.zoom * factor)) }
}

/** Shifts what is looked at: fractions of the longer side, to the right and away as the screen has them. */
export function shiftEye(right: number, away: number, width: number, height: number): void {
  const now = eye.peek()
  const longer = Math.max(width, height)
  const [cos, sin] = [Math.cos(now.azimuth), Math.sin(now.azimuth)]
  const dx = (cos * right - sin * away) * longer
  const dy = (-sin * right - cos * away) * longer
  eye.value = {
    ...now,
    centreX: unit(now.centreX + dx / width),
    centreY: unit(now.centreY + dy / height),
  }
}

/** The step on the map, along one axis, that looks most like this one on the screen (x right, y down). */
export function turned([x, y]: [number, number]): [number, number] {
  const quarter = Math.round(eye.peek().azimuth / (Math.PI / 2))
  let step: [number, number] = [x, y]
  for (let i = 0; i < ((quarter % 4) + 4) % 4; i++) step = [step[1], -step[0]]
  return step.map((part) => part + 0) as [number, number]
}

function unit(fraction: number): number {
  return Math.min(1, Math.max(0, fraction))
}
