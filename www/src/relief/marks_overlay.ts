/** What is drawn flat over the ground: start, goals, the cell cursor. Where a hill hides a mark, it is faint. */

import { drawMarksAt, type MarkPlaces } from '../drawing/draw_marks'
import { goalName } from '../model/goals'
import type { Ground, Vector } from '../model/relief_ground'
import type { Scenario } from '../model/session'
import type { Cursor } from '../stage/panel_view'
import { theme } from '../state'
import type { PanelCamera } from './panel_camera'

const CURSOR = {
  light: { ring: '#ffffff', line: '#1c1712' },
  dark: { ring: '#14161c', line: '#fff3dc' },
}
const FAINT = 0.42

export interface Scene {
  scenario: Scenario
  ground: Ground
  camera: PanelCamera
  stretch: number
  /** For each goal its place in the order of visits, from 1. */
  places: number[]
}

export function drawOverlay(
  canvas: HTMLCanvasElement,
  scene: Scene,
  cursor: Cursor | null,
  dpr: number,
): void {
  const context = canvas.getContext('2d')
  if (!context) return
  context.clearRect(0, 0, canvas.width, canvas.height)
  // The camera measures in pixels of the ground's canvas, which may be fewer.
  const { spec } = scene.scenario
  const look = {
    theme: theme.value,
    dpr,
    width: canvas.width,
    height: canvas.height,
    goalNames: spec.goals.map((_, index) => goalName(spec, index)),
  }
  if (cursor) drawCell(context, scene, cursor, dpr)
  const ends = endsOf(scene)
  for (const end of ends) drawStem(context, scene, end, dpr)
  for (const seen of [false, true]) {
    const at = (end: Vector) => (isSeen(scene, end) === seen ? scene.camera.project(end) : null)
    const [start, ...goals] = ends.map(({ top }) => at(top))
    const places: MarkPlaces = { start: start ?? null, goals }
    context.globalAlpha = seen ? 1 : FAINT
    drawMarksAt(context, look, places, markSize(spec.goals.length > 1) * dpr, scene.places)
    context.globalAlpha = 1
  }
}

/** CSS pixels. */
export const markSize = (several: boolean) => (several ? 9 : 8)

export interface EndPlace {
  /** Where the mark is: on the ground, by slices at its level. */
  top: Vector
  foot: Vector
}

/** Start, then the goals. */
export function endsOf({ scenario, ground }: Pick<Scene, 'scenario' | 'ground'>): EndPlace[] {
  const { spec } = scenario
  const rules = spec.terrain?.slices
  const place = ([x, y]: [number, number], level: number | undefined): EndPlace => {
    const foot: Vector = [x + 0.5, ground.at(x, y) || 0, y + 0.5]
    const height = rules && level !== undefined ? ground.level(level * rules.level) : foot[1]
    return { foot, top: [foot[0], height, foot[2]] }
  }
  return [
    place(spec.start, rules?.start_level),
    ...spec.goals.map(({ at }) => place(at, rules?.goal_level)),
  ]
}

function isSeen({ ground, camera, stretch }: Scene, [x, y, z]: Vector): boolean {
  return !ground.hides([x, y * stretch, z], camera.position, stretch)
}

function drawStem(
  context: CanvasRenderingContext2D,
  { camera }: Scene,
  { top, foot }: EndPlace,
  dpr: number,
): void {
  const [from, to] = [camera.project(foot), camera.project(top)]
  if (!from || !to || top[1] === foot[1]) return
  context.strokeStyle = CURSOR[theme.value].line
  context.lineWidth = 1.5 * dpr
  context.beginPath()
  context.moveTo(...from)
  context.lineTo(...to)
  context.stroke()
}

/** The outline of a cell on the ground; with a pin, since a cell may be smaller than a pixel. */
function drawCell(
  context: CanvasRenderingContext2D,
  { ground, camera }: Scene,
  { cell, byKeys }: Cursor,
  dpr: number,
): void {
  const [x, y] = cell
  const level = ground.at(x, y) || 0
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ].map(([dx = 0, dy = 0]) => {
    const [px, pz] = [x + dx, y + dy]
    return camera.project([px, ground.between(px, pz) || level, pz])
  })
  const middle = camera.project([x + 0.5, level, y + 0.5])
  if (!middle || corners.some((corner) => corner === null)) return
  const { ring, line } = CURSOR[theme.value]
  const outline = new Path2D()
  for (const corner of corners) if (corner) outline.lineTo(...corner)
  outline.closePath()
  if (byKeys) outline.arc(...middle, 5 * dpr, 0, 2 * Math.PI)
  context.lineJoin = 'round'
  for (const [colour, width] of [
    [ring, byKeys ? 5 : 3],
    [line, byKeys ? 2.25 : 1.25],
  ] as const) {
    context.strokeStyle = colour
    context.lineWidth = width * dpr
    context.stroke(outline)
  }
}
