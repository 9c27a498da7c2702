/** uPlot, set up for elevation profiles in the page's colours. */
import 'uplot/dist/uPlot.min.css'
import uPlot from 'uplot'
import type { ChartCursor } from './chart_cursor'
import { chartLook } from './chart_style'
import type { Profile } from './profile_data'

export interface Line {
  colour: string
  profile: Profile
}

export interface ProfileStyle {
  axisLabels: { x: string; y: string }
  cursor: ChartCursor
}

export function makeProfilePlot(host: HTMLElement, lines: Line[], style: ProfileStyle): uPlot {
  return new uPlot(options(host, lines, style), data(lines), host)
}

/** All paths on one axis, with holes where only other paths have a point. */
function data(lines: Line[]): uPlot.AlignedData {
  if (lines.length === 0) return [[]]
  return uPlot.join(
    lines.map(({ profile: { distances, altitudes, ground } }) =>
      ground ? [distances, ground, altitudes] : [distances, altitudes],
    ),
  )
}

function options(host: HTMLElement, lines: Line[], style: ProfileStyle): uPlot.Options {
  const { colour, axis, frame } = chartLook(host)
  return {
    ...frame,
    padding: [10, 16, 0, 0],
    plugins: [style.cursor.plugin],
    scales: { x: { time: false, range: style.cursor.range }, y: { range: yRange } },
    axes: [
      { ...axis, label: style.axisLabels.x, size: 22 },
      { ...axis, label: style.axisLabels.y, size: 48 },
    ],
    series: [{}, ...lines.flatMap((line) => series(line, colour('--text-muted')))],
    hooks: {
      draw: [(plot) => drawEnds(plot, lines, { start: colour('--start'), goal: colour('--goal') })],
    },
  }
}

function series({ colour, profile }: Line, muted: string): uPlot.Series[] {
  const points = { show: false }
  const path = { stroke: colour, width: 2, points, spanGaps: true }
  if (!profile.ground) return [path]
  return [{ stroke: `${muted}80`, width: 1, fill: `${muted}2e`, points, spanGaps: true }, path]
}

/** Start and goal as on the map: a disc and a diamond. */
function drawEnds(plot: uPlot, lines: Line[], colours: { start: string; goal: string }): void {
  const { ctx } = plot
  const radius = 4.5 * devicePixelRatio
  for (const { distances, altitudes } of lines.map(({ profile }) => profile)) {
    const at = (i: number): [number, number] => [
      plot.valToPos(distances.at(i) ?? 0, 'x', true),
      plot.valToPos(altitudes.at(i) ?? 0, 'y', true),
    ]
    const [[x0, y0], [x1, y1]] = [at(0), at(-1)]
    ctx.fillStyle = colours.start
    ctx.beginPath()
    ctx.arc(x0, y0, radius, 0, 2 * Math.PI)
    ctx.fill()
    ctx.fillStyle = colours.goal
    ctx.beginPath()
    ctx.moveTo(x1, y1 - 1.2 * radius)
    ctx.lineTo(x1 + 1.2 * radius, y1)
    ctx.lineTo(x1, y1 + 1.2 * radius)
    ctx.lineTo(x1 - 1.2 * radius, y1)
    ctx.fill()
  }
}

const yRange: uPlot.Range.Function = (_, min, max) => {
  if (min == null || max == null) return [0, 1]
  const room = Math.max((max - min) * 0.08, 0.5)
  return [min - room, max + room]
}
