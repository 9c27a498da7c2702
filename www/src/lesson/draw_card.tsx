/** Beside the map while a path is drawn: what it is worth so far, and what is missing. */
import { Eraser } from 'lucide'
import { useEffect, useId } from 'preact/hooks'
import { numbers } from '../i18n'
import { describeNotice } from '../i18n/errors'
import { t } from '../i18n/lesson'
import { LONGEST_LABEL } from '../model/lesson'
import { handUndoing, lesson, objectives, references, type Undoing } from '../state'
import { Button, IconButton } from '../ui/buttons'
import { UndoButtons } from '../ui/undo_buttons'
import { gapOf } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { OTHER_VALUES, objectiveWord } from '../words/objective_words'
import { Card } from './card'
import { drawKey } from './draw_input'
import {
  canRedo,
  canTakeBack,
  clearDrawn,
  drawingOn,
  redoPiece,
  refusal,
  rename,
  stopDrawing,
  takeBack,
} from './drawing'
import { handValue, measured } from './hand_panel'

const UNDOING: Undoing = {
  canUndo: canTakeBack,
  canRedo,
  undo: takeBack,
  redo: redoPiece,
  words: () => ({ undo: t('lesson.draw.undo'), redo: t('lesson.draw.redo') }),
}

export function DrawCard() {
  const drawn = lesson.value?.drawn
  useEffect(() => {
    handUndoing.value = UNDOING
    return () => {
      handUndoing.value = null
    }
  }, [])
  return (
    <Card
      title={t('lesson.draw.title')}
      line={refusal.value || standingWords() || t('lesson.draw.how')}
      panelId={drawingOn.value ?? 0}
      testId="draw-card"
      onClose={stopDrawing}
      onKey={drawKey}
    >
      <Actions />
      <Label label={drawn?.label ?? null} />
      <p role="status" data-testid="draw-standing">
        {standingWords()}
      </p>
      {refusal.value !== '' && (
        <p class="draw-refusal" role="alert" data-testid="draw-refusal">
          {refusal.value}
        </p>
      )}
      <p class="hint">{t('lesson.draw.how')}</p>
      <p class="hint">{t('lesson.draw.undoing')}</p>
    </Card>
  )
}

function Actions() {
  return (
    <div class="card-actions">
      <UndoButtons of={UNDOING} testId="draw-" />
      <IconButton
        icon={Eraser}
        label={t('lesson.draw.clear')}
        testId="draw-clear"
        disabled={!lesson.value?.drawn}
        onClick={clearDrawn}
      />
      <span class="spacer" />
      <Button
        label={t('lesson.draw.done')}
        tone="primary"
        testId="draw-done"
        onClick={stopDrawing}
      />
    </div>
  )
}

/** Null while there is no path to be called anything. */
function Label({ label }: { label: string | null }) {
  const id = useId()
  return (
    <span class="field">
      <label for={id} class="field-label">
        {t('lesson.draw.label')}
      </label>
      <input
        id={id}
        class="input"
        maxLength={LONGEST_LABEL}
        value={label ?? t('lesson.draw.byHand')}
        disabled={label === null}
        data-testid="draw-label"
        onChange={(event) => rename(event.currentTarget.value.trim() || t('lesson.draw.byHand'))}
      />
    </span>
  )
}

function standingWords(): string {
  const now = measured.value
  if (!now) return ''
  const { found, refused, drawn } = now
  const { whole } = numbers.value
  if (!found) return t('lesson.draw.notHere', { why: refused })
  if (found.flaw) return t('lesson.draw.flaw', { why: describeNotice(found.flaw) })
  const { metrics, missing } = found
  const steps = t('lesson.draw.steps', { count: drawn.path.length - 1 })
  if (!metrics || missing) {
    const [x, y] = missing ?? [0, 0]
    return `${steps}. ${t('lesson.draw.missing', { x, y })}`
  }
  const told = t('lesson.draw.complete', {
    length: lengthShown(metrics.length),
    turns: whole.format(metrics.turns),
    clearance: lengthShown(metrics.min_clearance),
  })
  return [told, ...valueWords()].join(' ')
}

/** What it is measured by, where that is not its length, and how that compares. */
function valueWords(): string[] {
  const objective = objectives.value.find((each) => handValue(each) !== null)
  const value = objective ? handValue(objective) : null
  if (!objective || value === null) return []
  const what = OTHER_VALUES[objectiveWord(objective)]
  const valued = what ? [t('lesson.draw.valued', { what: t(what), value: lengthShown(value) })] : []
  const gap = gapOf(value, references.value[objective] ?? null)
  if (gap === null) return valued
  const compared =
    gap <= 0
      ? t('lesson.draw.best')
      : t('lesson.draw.gap', { gap: numbers.value.percent.format(gap).replace('+', '') })
  return [...valued, compared]
}
