/** The part of the map dialog in which a picture is read as the figure of a grid. */
import type { Figure } from '@pkg/formicarium'
import { SkipForward, Undo2, ZoomIn, ZoomOut } from 'lucide'
import type { RefObject } from 'preact'
import { useEffect, useMemo, useRef } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { describeNotice } from '../i18n/errors'
import type { Cell } from '../model/cell'
import { Button, IconButton } from '../ui/buttons'
import { Labelled, Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'
import { cellAt, classOf, countsOf, type Draft, MARKS, type Mark, markOf } from './figure_draft'
import { LatticeFields } from './figure_fields'
import { type FigureHand, useFigureHand } from './figure_hand'
import { letterOf, paperOf, tintOf } from './figure_paint'
import { TOOLS } from './figure_pointer'
import { ZOOMS } from './figure_sight'
import type { FigureState } from './figure_state'
import { FigureView } from './figure_view'

export function FigureBody({ figure }: { figure: FigureState }) {
  const pane = useRef<HTMLDivElement>(null)
  const hand = useFigureHand(figure)
  const root = useRef<HTMLDivElement>(null)
  useUndoKey(root, figure)
  return (
    <div ref={root} class="figure" data-testid="figure">
      <Tools figure={figure} hand={hand} onNext={() => pane.current?.focus()} />
      <div class="raster">
        <div>
          <FigureView figure={figure} hand={hand} pane={pane} />
          <PointedCell figure={figure} hand={hand} />
        </div>
        <div class="figure-told">
          <Facts figure={figure} />
          <Notices figure={figure} />
        </div>
      </div>
      {figure.draft && <LatticeFields draft={figure.draft} onChange={figure.change} />}
      {figure.error !== null && <FormError error={figure.error} />}
      <p class="hint" id="figure-keys">
        {t('figure.keys')}
      </p>
    </div>
  )
}

/** Why the figure cannot be opened yet; its room stays, so that nothing moves once it can. */
export function WhyNotYet({ figure: { draft, found, isPlaced } }: { figure: FigureState }) {
  if (found || !draft) return null
  return (
    <p class="hint figure-why" role="status" data-testid="figure-why">
      <span class={isPlaced ? 'figure-why-gone' : ''}>{t('figure.placeFirst')}</span>
    </p>
  )
}

/** Anywhere in the dialog but where numbers are typed, which have an undo of their own. */
function useUndoKey(root: RefObject<HTMLDivElement | null>, { undo }: FigureState): void {
  const act = useRef(undo)
  act.current = undo
  useEffect(() => {
    const dialog = root.current?.closest('dialog')
    const onKey = (event: KeyboardEvent) => {
      const isTyped = (event.target as HTMLElement).matches('input[type="number"]')
      const isUndo = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z'
      if (isTyped || !isUndo || event.shiftKey) return
      event.preventDefault()
      act.current()
    }
    dialog?.addEventListener('keydown', onKey)
    return () => dialog?.removeEventListener('keydown', onKey)
  }, [])
}

interface ToolsProps {
  figure: FigureState
  hand: FigureHand
  onNext: () => void
}

function Tools({ figure, hand, onNext }: ToolsProps) {
  return (
    <div class="figure-tools">
      <Labelled label={t('figure.tool')}>
        <Segmented
          label={t('figure.tool')}
          value={hand.tool}
          options={TOOLS.map((tool) => ({
            value: tool,
            label: t(`figure.tools.${tool}`),
            testId: `figure-tool-${tool}`,
          }))}
          onChange={hand.choose}
        />
      </Labelled>
      <div class="figure-buttons">
        <IconButton
          icon={Undo2}
          label={t('figure.undo')}
          keys="Ctrl+Z"
          testId="figure-undo"
          disabled={!figure.canUndo}
          onClick={() => figure.undo()}
        />
        <IconButton
          icon={ZoomOut}
          label={t('figure.smaller')}
          keys="−"
          testId="figure-smaller"
          disabled={hand.zoom === 0}
          onClick={() => hand.zoomTo(hand.zoom - 1)}
        />
        <IconButton
          icon={ZoomIn}
          label={t('figure.larger')}
          keys="+"
          testId="figure-larger"
          disabled={hand.zoom === ZOOMS.length - 1}
          onClick={() => hand.zoomTo(hand.zoom + 1)}
        />
        <Button
          icon={SkipForward}
          label={t('figure.next')}
          testId="figure-next"
          disabled={!figure.classes?.includes(classOf('unsure'))}
          onClick={() => {
            hand.toNextUnsure()
            onNext()
          }}
        />
      </div>
    </div>
  )
}

/** Tells of the cell under the cursor, in a line that is always there. */
function PointedCell({
  figure: { draft, classes, read },
  hand,
}: {
  figure: FigureState
  hand: FigureHand
}) {
  const { pointed } = hand
  return (
    <p class="hint figure-pointed" aria-live="polite" data-testid="figure-pointed">
      {pointed && draft && classes ? pointedWords(pointed, draft, classes, read) : '\u00a0'}
    </p>
  )
}

function pointedWords(
  [column, row]: Cell,
  { lattice, edits }: Draft,
  classes: Uint8Array,
  read: Figure | null,
): string {
  const cell = cellAt([column, row], lattice)
  const mark = markOf(classes[cell] ?? 0)
  const words = { column, row, mark: t(`figure.marks.${mark}`) }
  // Of what was set by hand, and of what is unsure, no share says more.
  if (edits.has(cell) || mark === 'unsure') return t('figure.pointed', words)
  const sure = numbers.value.share.format((read?.confidence[cell] ?? 0) / 255)
  return t('figure.pointedSure', { ...words, sure })
}

/** How many cells are what; the legend at the same time. */
function Facts({ figure: { draft, classes } }: { figure: FigureState }) {
  const { columns, rows } = draft?.lattice ?? { columns: 0, rows: 0 }
  const counts = useMemo(() => (classes ? countsOf(classes) : []), [classes])
  return (
    <dl class="raster-facts map-facts" aria-live="polite">
      <div>
        <dt>{t('raster.size')}</dt>
        <dd data-testid="figure-size">{draft ? `${whole(columns)} × ${whole(rows)}` : '…'}</dd>
      </div>
      {MARKS.map((mark, at) => (
        <div key={mark} class={mark === 'unsure' && counts[at] ? 'figure-warns' : ''}>
          <dt>
            <span
              class="figure-swatch"
              style={{ '--tint': tintOf(mark), '--paper': paperOf(mark) }}
              aria-hidden="true"
            >
              {letterOf(mark)}
            </span>
            {t(`figure.marks.${mark}`)}
          </dt>
          <dd data-testid={`figure-${mark}`}>{countOf(counts[at])}</dd>
        </div>
      ))}
    </dl>
  )
}

/** What was assumed, but for what the counts tell better. */
function Notices({ figure: { draft, read, classes } }: { figure: FigureState }) {
  if (!draft) return null
  const lacks = (end: Mark) => classes !== null && !classes.includes(classOf(end))
  const unsure = classes?.includes(classOf('unsure'))
  const guessed = read?.warnings.filter(
    ({ kind }) => kind === 'figure-ends-guessed' && draft.edits.size === 0,
  )
  return (
    <ul class="map-notices" data-testid="figure-notices">
      {guessed?.map((notice) => (
        <li key={notice.kind}>{describeNotice(notice)}</li>
      ))}
      {unsure && <li>{t('figure.unsure')}</li>}
      {(lacks('start') || lacks('goal')) && <li>{t('figure.missing')}</li>}
    </ul>
  )
}

const whole = (value: number) => numbers.value.whole.format(value)
const countOf = (count: number | undefined) => (count === undefined ? '…' : whole(count))
