/** The followed ant on the map: its way so far, and the moves that it weighs. A magnified map goes with it. */
import { useEffect } from 'preact/hooks'
import { reveal, viewpoint } from '../model/viewpoint'
import { MoveArrows } from '../playback'
import type { CanvasSize } from '../stage/panel_view'
import { lessonMode, scenario } from '../state'
import { seen } from './follow'
import { optionsOf, question } from './guess'
import { cellSize, lineOn, pointOn } from './map_lines'
import { movesOfTurn } from './move_rows'
import { Overlay } from './overlay'
import { revealed } from './questions'

export function AntTrail({ size }: { size: CanvasSize }) {
  const now = seen.value
  const at = now?.turn?.way.at(-1)
  useEffect(() => {
    const spec = scenario.peek()?.spec
    if (at && spec) viewpoint.value = reveal(viewpoint.peek(), at, size, spec)
  }, [at?.join()])
  if (!now?.turn || !at) return null
  const { panelId, turn } = now
  const [x, y] = pointOn(size, at)
  const guessing = lessonMode.value === 'guess' && !revealed.value
  return (
    <>
      {!guessing && turn.moves.length > 0 && (
        <MoveArrows
          cell={at}
          moves={movesOfTurn(turn).filter(({ weight }) => weight > 0)}
          size={size}
          panelId={panelId}
        />
      )}
      <Overlay size={size} class="ant-trail" testId="ant-trail">
        <polyline class="halo" points={lineOn(size, turn.way)} />
        <polyline class="line" points={lineOn(size, turn.way)} />
        <circle class="ring" cx={x} cy={y} r={Math.max(6, 0.42 * cellSize(size))} />
        <circle class="ant" cx={x} cy={y} r={3.5} />
        {guessing && <Options size={size} />}
        {revealed.value && <Taken size={size} to={revealed.value.taken.to} />}
      </Overlay>
    </>
  )
}

/** Numbers on the cells that may be guessed. */
function Options({ size }: { size: CanvasSize }) {
  const turn = question.value
  if (!turn) return null
  const side = cellSize(size)
  return (
    <>
      {optionsOf(turn).map(({ to }, index) => {
        const [x, y] = pointOn(size, to)
        return (
          <g key={to.join()} class="option">
            <rect x={x - side / 2} y={y - side / 2} width={side} height={side} />
            <text x={x} y={y} font-size={Math.min(15, 0.7 * side)}>
              {index + 1}
            </text>
          </g>
        )
      })}
    </>
  )
}

function Taken({ size, to }: { size: CanvasSize; to: readonly [number, number] }) {
  const side = cellSize(size)
  const [x, y] = pointOn(size, to)
  return <rect class="taken" x={x - side / 2} y={y - side / 2} width={side} height={side} />
}
