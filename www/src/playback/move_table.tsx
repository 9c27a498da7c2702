/** The moves of a cell as a table, clockwise from the north. */
import { language } from '../i18n'
import { t } from '../i18n/playback'
import type { Cell } from '../model/cell'
import { headingOf, type Move } from './moves'

interface MoveTableProps {
  moves: Move[]
  cell: Cell
  /** By slices where they begin, else 0. */
  level: number
  /** The move that is marked, e.g. as taken. */
  marked?: Move | null
}

export function MoveTable({ moves, cell, level, marked }: MoveTableProps) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="moves-scroll" tabIndex={0} aria-label={t('playback.moves.caption')}>
      <table class="moves" data-testid="moves">
        <thead>
          <tr>
            <th scope="col">{t('playback.moves.to')}</th>
            <th scope="col" title={t('playback.moves.trailHint')}>
              {t('playback.moves.trail')}
            </th>
            <th scope="col" title={t('playback.moves.heuristicHint')}>
              {t('playback.moves.heuristic')}
            </th>
            <th scope="col" title={t('playback.moves.weightHint')}>
              {t('playback.moves.weight')}
            </th>
            <th scope="col" title={t('playback.moves.probabilityHint')}>
              {t('playback.moves.probability')}
            </th>
          </tr>
        </thead>
        <tbody>
          {moves.map((move) => (
            <Row
              key={`${move.x},${move.y},${move.level}`}
              move={move}
              cell={cell}
              level={level}
              marked={move === marked}
            />
          ))}
        </tbody>
      </table>
    </section>
  )
}

interface RowProps {
  move: Move
  cell: Cell
  level: number
  marked: boolean
}

function Row({ move, cell, level, marked }: RowProps) {
  const { x, y, trail, heuristic, weight, probability } = move
  return (
    <tr
      data-testid="move"
      data-marked={marked}
      data-to={`${x},${y}`}
      data-probability={probability}
    >
      <th scope="row">
        <span
          class="heading"
          aria-hidden="true"
          style={{ transform: `rotate(${headingOf(move, cell)}deg)` }}
        >
          →
        </span>
        {x}, {y}
        {level > 0 && <span class="climb"> {climb(move.level - level)}</span>}
      </th>
      <td>{quantity(trail)}</td>
      <td>{quantity(heuristic)}</td>
      <td>{weight > 0 ? quantity(weight) : '–'}</td>
      <td class="probability">
        <span class="bar" aria-hidden="true" style={{ transform: `scaleX(${probability})` }} />
        <span>{percent(probability)}</span>
      </td>
    </tr>
  )
}

const climb = (levels: number) => (levels === 0 ? '±0' : levels > 0 ? `+${levels}` : `−${-levels}`)

/** Trails and heuristics span decades. */
function quantity(value: number): string {
  const tiny = value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5)
  return new Intl.NumberFormat(language.value, {
    maximumSignificantDigits: 3,
    notation: tiny ? 'scientific' : 'standard',
  }).format(value)
}

/** What is possible is never shown as 0. */
export function percent(share: number): string {
  const format = new Intl.NumberFormat(language.value, {
    style: 'percent',
    minimumFractionDigits: 1,
    maximumFractionDigits: 1,
  })
  return share > 0 && share < 0.0005 ? `< ${format.format(0.001)}` : format.format(share)
}
