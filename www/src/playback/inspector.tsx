/** Beside a cell: the moves of an ant on it, with pheromone, heuristic and probability; on the map they are arrows. */
import { type ReadonlySignal, useSignal, useSignalEffect } from '@preact/signals'
import { ChevronDown, ChevronUp } from 'lucide'
import { useLayoutEffect, useRef } from 'preact/hooks'
import { client } from '../engine/panel_clients'
import { numbers } from '../i18n'
import { type PlaybackKey, t } from '../i18n/playback'
import type { Cell } from '../model/cell'
import { isBlocked, isInside } from '../model/edit'
import { goalIndexAt } from '../model/goals'
import { type CanvasSize, place } from '../stage/panel_view'
import {
  inspected,
  liveTick,
  lookedAt,
  panelById,
  plannerEntry,
  scenario,
  shownOf,
  tool,
} from '../state'
import { openDialog } from '../state/dialogs'
import { CloseButton, IconButton } from '../ui/buttons'
import { panelTitle } from '../words/planner_words'
import { MoveArrows } from './move_arrows'
import { MoveTable } from './move_table'
import { byDirection, coloniesOf, type Move, movesOf } from './moves'

interface InspectorProps {
  panelId: number
  /** Of the flat map's canvas; null where the map is not flat, which has no arrows. */
  size: ReadonlySignal<CanvasSize> | null
}

interface Known {
  /** Of which cell. */
  key: string
  level: number
  moves: Move[]
}

export function Inspector({ panelId, size }: InspectorProps) {
  const known = useSignal<Known | null>(null)
  const colony = useSignal(0)
  useSignalEffect(() =>
    keepAsking(panelId, (answer) => {
      known.value = answer
    }),
  )
  const here = inspected.value
  if (here?.panelId !== panelId) return null
  const now = known.value?.key === keyOf(here.cell) ? known.value : null
  const colonies = coloniesOf(now?.moves ?? [])
  const chosen = colonies.includes(colony.value) ? colony.value : (colonies[0] ?? 0)
  const moves = byDirection(
    (now?.moves ?? []).filter((move) => move.colony === chosen),
    here.cell,
  )
  return (
    <>
      {size && <MoveArrows cell={here.cell} moves={moves} size={size.value} panelId={panelId} />}
      <Card panelId={panelId} cell={here.cell} size={size?.value ?? null}>
        <Levels level={now?.level ?? 0} />
        {colonies.length > 1 && (
          <Colonies
            all={colonies}
            chosen={chosen}
            onChoose={(one) => {
              colony.value = one
            }}
          />
        )}
        {moves.length > 0 ? (
          <MoveTable moves={moves} cell={here.cell} level={now?.level ?? 0} />
        ) : (
          <p class="why-none" data-testid="no-moves">
            {t(now ? whyNone(panelId, here.cell) : 'playback.moves.wait')}
          </p>
        )}
      </Card>
    </>
  )
}

const keyOf = (cell: Cell) => cell.join()

/** Asks anew whenever the run, the iteration on show or the cell is another. */
function keepAsking(panelId: number, take: (answer: Known) => void): void {
  liveTick.value
  lookedAt.value
  const panel = panelById(panelId)
  if (panel) shownOf(panel)
  const here = inspected.value
  if (here?.panelId !== panelId) return
  const { cell, level } = here
  if (!scenario.value || !isInside(scenario.value, cell)) {
    inspected.value = null
    return
  }
  void client(panelId)
    ?.ask({ about: 'moves', cell, level })
    .then((answer) => {
      if (inspected.peek() !== here) return
      const moves = answer ? movesOf(answer) : []
      take({ key: keyOf(cell), level: answer?.level ?? 0, moves })
    })
}

/** Why a cell has no moves, the first reason that applies. */
function whyNone(panelId: number, cell: Cell): PlaybackKey {
  const family = plannerEntry(panelById(panelId)?.setup.planner ?? '')?.family
  if (family === 'swarm') return 'playback.moves.swarm'
  if (family !== 'ant-colony') return 'playback.moves.noAnts'
  const now = scenario.value
  if (now && isBlocked(now, cell)) return 'playback.moves.wall'
  if (now && goalIndexAt(now, cell) >= 0) return 'playback.moves.goal'
  return 'playback.moves.none'
}

interface CardProps {
  panelId: number
  cell: Cell
  size: CanvasSize | null
  children: preact.ComponentChildren
}

/** Stays clear of the cell: on the other half of the map. Esc closes it and gives the focus back to the map. */
function Card({ panelId, cell, size, children }: CardProps) {
  const card = useRef<HTMLElement>(null)
  const close = () => {
    inspected.value = null
    document.querySelector<HTMLElement>(`[data-testid="stage-${panelId}"]`)?.focus()
  }
  // As soon as it can be seen: the next key may be there before the next frame.
  useLayoutEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || event.defaultPrevented || openDialog.peek()) return
      if (event.target instanceof Element && event.target.closest('[role="menu"]')) return
      event.preventDefault()
      close()
    }
    // Handled before the page's own Escape, which goes back to drawing walls.
    addEventListener('keydown', onKey, { capture: true })
    return () => removeEventListener('keydown', onKey, { capture: true })
  }, [panelId])
  useSignalEffect(() => {
    if (tool.value !== 'inspect') inspected.value = null
  })
  const [x, y] = cell
  const title = t('playback.moves.title', { x, y })
  return (
    <section
      ref={card}
      class="moves-card"
      data-side={sideOf(cell, size)}
      data-end={endOf(cell, size)}
      aria-label={title}
      data-testid="moves-card"
    >
      <header>
        <h3>{title}</h3>
        <CloseButton
          label={t('playback.moves.close')}
          keys="Esc"
          testId="close-moves"
          onClick={close}
        />
      </header>
      <p class="hint" title={t('playback.moves.ofHint')}>
        {t('playback.moves.of', { planner: panelTitle(panelId), when: when(panelId) })}
        <span class="visually-hidden">. {t('playback.moves.ofHint')}</span>
      </p>
      {children}
    </section>
  )
}

function sideOf([x]: Cell, size: CanvasSize | null): 'left' | 'right' {
  if (!size) return 'right'
  const { scale, originX } = place(size)
  return originX + (x + 0.5) * scale > size.width / 2 ? 'left' : 'right'
}

/** On a phone there is no room beside the cell: above or below it. */
function endOf([, y]: Cell, size: CanvasSize | null): 'top' | 'bottom' {
  if (!size) return 'bottom'
  const { scale, originY } = place(size)
  return originY + (y + 0.5) * scale > size.height / 2 ? 'top' : 'bottom'
}

function when(panelId: number): string {
  const panel = panelById(panelId)
  const iteration = (panel && shownOf(panel).summary?.iteration) ?? 0
  if (iteration === 0) return t('playback.moves.before')
  return t('playback.moves.atIteration', { iteration: numbers.value.whole.format(iteration) })
}

/** By slices a cell has many places, one above the other. */
function Levels({ level }: { level: number }) {
  const levels = scenario.value?.spec.terrain?.slices?.levels ?? 0
  if (levels === 0 || level === 0) return null
  const go = (to: number) => {
    const here = inspected.peek()
    if (here) inspected.value = { ...here, level: Math.min(levels, Math.max(1, to)) }
  }
  return (
    <p class="level-row">
      <span data-testid="moves-level">{t('playback.moves.level', { level })}</span>
      <IconButton
        icon={ChevronDown}
        label={t('playback.moves.lower')}
        tone="quiet"
        size={16}
        testId="level-lower"
        disabled={level <= 1}
        onClick={() => go(level - 1)}
      />
      <IconButton
        icon={ChevronUp}
        label={t('playback.moves.higher')}
        tone="quiet"
        size={16}
        testId="level-higher"
        disabled={level >= levels}
        onClick={() => go(level + 1)}
      />
    </p>
  )
}

interface ColoniesProps {
  all: number[]
  chosen: number
  onChoose: (colony: number) => void
}

/** Legs of a tour, or the two teams that set out from both ends. */
function Colonies({ all, chosen, onChoose }: ColoniesProps) {
  const several = (scenario.value?.spec.goals.length ?? 1) > 1
  const name = (colony: number) =>
    several
      ? t('playback.moves.leg', { leg: colony + 1 })
      : t(colony === 0 ? 'playback.moves.fromStart' : 'playback.moves.fromGoal')
  return (
    <fieldset class="colonies" aria-label={t('playback.moves.colonies')}>
      {all.map((colony) => (
        <button
          key={colony}
          type="button"
          aria-pressed={colony === chosen}
          data-testid={`colony-${colony}`}
          onClick={() => onChoose(colony)}
        >
          {name(colony)}
        </button>
      ))}
    </fieldset>
  )
}
