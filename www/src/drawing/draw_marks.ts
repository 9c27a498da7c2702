/** Start and goals, with names and visiting order where there are several. Pure functions of the view. */
import type { ScenarioSpec } from '@pkg/formicarium'
import type { PanelView } from '../model/messages'
import { centre } from './draw_map'
import { markRadius } from './mark_radius'

/** The methods that canvases of a worker and of the page share. */
type Context = Pick<
  OffscreenCanvasRenderingContext2D,
  | 'arc'
  | 'beginPath'
  | 'closePath'
  | 'fill'
  | 'fillStyle'
  | 'fillText'
  | 'font'
  | 'lineJoin'
  | 'lineTo'
  | 'lineWidth'
  | 'measureText'
  | 'moveTo'
  | 'roundRect'
  | 'stroke'
  | 'strokeStyle'
  | 'textAlign'
  | 'textBaseline'
>
type Point = [number, number]
type Look = Pick<PanelView, 'theme' | 'dpr' | 'width' | 'height' | 'goalNames'>

/** Where the marks are on the canvas; null for one that is not to be drawn. */
export interface MarkPlaces {
  start: Point | null
  goals: (Point | null)[]
}

const TURN = 2 * Math.PI
const FONT = 'system-ui, sans-serif'
/** Longer names are cut; the table of goals has them in full. */
const MOST_LETTERS = 14

export const MARK_COLOURS = {
  light: {
    ring: '#ffffff',
    start: '#0c8a4d',
    goal: '#d3263a',
    onGoal: '#ffffff',
    label: 'rgba(255, 255, 255, 0.92)',
    text: '#14211d',
  },
  dark: {
    ring: '#14161c',
    start: '#3ddc84',
    goal: '#ff6b76',
    onGoal: '#14161c',
    label: 'rgba(16, 20, 26, 0.88)',
    text: '#f3efe6',
  },
}

/**
 * The start is a green disc with a hole, a goal a red diamond: told apart by shape as well as by colour. `places`: for each goal its
 * place in the order of visits, from 1; empty while there is no order.
 */
export function drawMarks(
  context: Context,
  view: PanelView,
  spec: ScenarioSpec,
  places: number[],
): void {
  const radius = markRadius(view, spec.goals.length > 1)
  const at = {
    start: centre(view, ...spec.start),
    goals: spec.goals.map((goal) => centre(view, ...goal.at)),
  }
  drawMarksAt(context, view, at, radius, places)
}

export function drawMarksAt(
  context: Context,
  look: Look,
  { start, goals }: MarkPlaces,
  radius: number,
  places: number[],
): void {
  const several = goals.length > 1
  // Labels first, so that they never cover a mark.
  if (several) {
    for (const [i, at] of goals.entries())
      if (at) drawName(context, look, at, look.goalNames[i] ?? '', radius)
  }
  for (const [i, at] of goals.entries()) {
    if (!at) continue
    drawDiamond(context, look, at, radius)
    const place = places[i]
    if (several && place) drawPlace(context, look, at, place, radius)
  }
  if (start) drawDisc(context, look, start, radius)
}

function drawDisc(context: Context, view: Look, [x, y]: Point, radius: number): void {
  const colours = MARK_COLOURS[view.theme]
  for (const [colour, size] of [
    [colours.ring, radius + 1.5 * view.dpr],
    [colours.start, radius],
    [colours.ring, 0.36 * radius],
  ] as const) {
    context.fillStyle = colour
    context.beginPath()
    context.arc(x, y, size, 0, TURN)
    context.fill()
  }
}

function drawDiamond(context: Context, view: Look, [x, y]: Point, radius: number): void {
  const reach = 1.18 * radius
  context.beginPath()
  context.moveTo(x, y - reach)
  context.lineTo(x + reach, y)
  context.lineTo(x, y + reach)
  context.lineTo(x - reach, y)
  context.closePath()
  context.lineJoin = 'round'
  context.strokeStyle = MARK_COLOURS[view.theme].ring
  context.lineWidth = 3 * view.dpr
  context.stroke()
  context.fillStyle = MARK_COLOURS[view.theme].goal
  context.fill()
}

function drawPlace(
  context: Context,
  view: Look,
  [x, y]: Point,
  place: number,
  radius: number,
): void {
  const size = radius * (place < 10 ? 1.2 : 0.95)
  context.font = `700 ${size}px ${FONT}`
  context.textAlign = 'center'
  context.textBaseline = 'alphabetic'
  context.fillStyle = MARK_COLOURS[view.theme].onGoal
  context.fillText(String(place), x, y + 0.36 * size)
}

/** Beside the marker, on whichever side the canvas has room; never beyond its edges while the marker is within them. */
function drawName(context: Context, view: Look, [x, y]: Point, name: string, radius: number): void {
  const { dpr } = view
  const size = Math.min(15 * dpr, Math.max(11 * dpr, radius))
  const text = name.length > MOST_LETTERS ? `${name.slice(0, MOST_LETTERS - 1)}…` : name
  if (text === '') return
  context.font = `600 ${size}px ${FONT}`
  const width = context.measureText(text).width + 8 * dpr
  const gap = 1.18 * radius + 3 * dpr
  const height = 1.35 * size
  const beside = x + gap + width > view.width ? x - gap - width : x + gap
  const seen = x >= 0 && y >= 0 && x <= view.width && y <= view.height
  const left = seen ? clamp(beside, view.width - width) : beside
  const top = seen ? clamp(y - height / 2, view.height - height) : y - height / 2
  context.fillStyle = MARK_COLOURS[view.theme].label
  context.beginPath()
  context.roundRect(left, top, width, height, 4 * dpr)
  context.fill()
  context.textAlign = 'left'
  context.textBaseline = 'alphabetic'
  context.fillStyle = MARK_COLOURS[view.theme].text
  context.fillText(text, left + 4 * dpr, top + height / 2 + 0.35 * size)
}

const clamp = (value: number, most: number) => Math.max(0, Math.min(value, most))
