/** What moves, and the robot with its path and its way, drawn over the map. */
import type { Track } from '@pkg/formicarium'
import { cellSize, lineOn, pointOn } from '../lesson/map_lines'
import { Overlay } from '../lesson/overlay'
import type { Cell } from '../model/cell'
import { full, movingOf } from '../model/moving'
import { squareAbout } from '../model/spans'
import type { CanvasSize } from '../stage/panel_view'
import { panelColour, scenario } from '../state'
import { driven, drivingPanel, standing } from './drive'
import { edited } from './moving'

/** CSS pixels below which a robot is drawn no smaller, so that it is seen. */
const LEAST_ROBOT = 4

export function Marks({ size }: { size: CanvasSize }) {
  const now = scenario.value
  if (!now) return null
  const { tracks, changes, sight } = movingOf(now)
  const state = standing.value
  const hand = edited.value
  const inHand = (list: 'tracks' | 'changes', i: number) => hand?.list === list && hand.index === i
  return (
    <Overlay
      size={size}
      class="drive-marks"
      testId="drive-marks"
      colour={panelColour(drivingPanel.value?.id ?? 0)}
    >
      {changes.map((change, i) => (
        <Walls
          key={i}
          size={size}
          {...full(change)}
          inHand={inHand('changes', i)}
          made={change.at_step <= (state?.last.step ?? -1)}
        />
      ))}
      {tracks.map((track, i) => (
        <Way key={i} size={size} track={track} inHand={inHand('tracks', i)} />
      ))}
      {state && (
        <>
          <polyline class="halo" points={lineOn(size, driven.value)} />
          <polyline class="way" points={lineOn(size, driven.value)} data-testid="drive-way" />
          <polyline class="plan" points={lineOn(size, state.path)} data-testid="drive-plan" />
          {state.believed_blocked.map((cell) => (
            <Square key={`b${cell}`} size={size} at={cell} class="believed-blocked" />
          ))}
          {state.believed_free.map((cell) => (
            <Square key={`f${cell}`} size={size} at={cell} class="believed-free" />
          ))}
        </>
      )}
      {tracks.map((track, i) => (
        <Obstacle key={i} size={size} track={track} at={state ? state.obstacles[i]?.at : null} />
      ))}
      {state && <RobotMark size={size} at={state.last.at} sight={sight ?? null} />}
    </Overlay>
  )
}

/** The track of an obstacle, its first cell as a ring. */
function Way({ size, track, inHand }: { size: CanvasSize; track: Track; inHand: boolean }) {
  const [x, y] = pointOn(size, track.cells[0] ?? [0, 0])
  return (
    <g class="track" data-in-hand={inHand}>
      <polyline class="halo" points={lineOn(size, track.cells)} />
      <polyline class="line" points={lineOn(size, track.cells)} />
      <circle cx={x} cy={y} r={4} />
    </g>
  )
}

/** On its first cell, where no drive tells its place; cut off at the border of the map. */
function Obstacle(props: { size: CanvasSize; track: Track; at: Cell | null | undefined }) {
  const { size, track, at } = props
  const centre = at === null ? track.cells[0] : at
  const spec = scenario.value?.spec
  if (!centre || !spec) return null
  const rows = squareAbout(centre, track.size ?? 1, spec)
  const [first] = rows
  if (!first) return null
  return (
    <Square
      size={size}
      at={[first.from, first.y]}
      wide={first.to - first.from + 1}
      high={rows.length}
      class="obstacle"
    />
  )
}

interface WallsProps {
  size: CanvasSize
  blocked: Cell[]
  freed: Cell[]
  inHand: boolean
  /** The robot's step has come to them. */
  made: boolean
}

function Walls({ size, blocked, freed, inHand, made }: WallsProps) {
  return (
    <g class="walls" data-in-hand={inHand} data-made={made}>
      {blocked.map((cell) => (
        <Square key={`b${cell}`} size={size} at={cell} class="blocked" />
      ))}
      {freed.map((cell) => (
        <Square key={`f${cell}`} size={size} at={cell} class="freed" />
      ))}
    </g>
  )
}

interface SquareProps {
  size: CanvasSize
  /** Its upper left cell. */
  at: readonly [number, number]
  /** Cells. */
  wide?: number
  high?: number
  class: string
}

function Square({ size, at, wide = 1, high = 1, class: name }: SquareProps) {
  const cell = cellSize(size)
  const [x, y] = pointOn(size, at)
  const inset = Math.min(1.5, 0.1 * cell)
  return (
    <rect
      class={name}
      x={x - cell / 2 + inset}
      y={y - cell / 2 + inset}
      width={wide * cell - 2 * inset}
      height={high * cell - 2 * inset}
    />
  )
}

/** To scale where it has a radius, and with a ring as far as it sees. */
function RobotMark({ size, at, sight }: { size: CanvasSize; at: Cell; sight: number | null }) {
  const [x, y] = pointOn(size, at)
  const cell = cellSize(size)
  const spec = scenario.value?.spec
  const radius = spec?.robot ? (spec.robot.radius / spec.resolution) * cell : 0
  return (
    <g class="robot" data-testid="drive-robot" data-at={at.join()}>
      {sight !== null && <circle class="sight" cx={x} cy={y} r={sight * cell} />}
      {radius > 0 && <circle class="extent" cx={x} cy={y} r={radius} />}
      <circle class="body" cx={x} cy={y} r={Math.max(LEAST_ROBOT, Math.min(9, 0.36 * cell))} />
    </g>
  )
}
