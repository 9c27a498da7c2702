/** The list of what moves: each can be taken in hand, changed and removed. */
import { Blocks, Route, Sparkles, Trash2 } from 'lucide'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/drive'
import type { Cell } from '../model/cell'
import { full } from '../model/moving'
import { notifyError } from '../state'
import { Button, IconButton } from '../ui/buttons'
import { failure } from './drive'
import { type Edited, edited, makeExample, movingNow, refusal, remove } from './moving'
import { TrackFields, WallFields } from './moving_fields'
import { showCell } from './show_cell'
import { failureWords } from './standing_words'

export function MovingList() {
  const { tracks, changes } = movingNow()
  const hand = edited.value
  const isNew = hand?.index === null
  return (
    <section class="drive-moving" aria-label={t('drive.moving')} data-testid="drive-moving">
      <h4>{t('drive.moving')}</h4>
      {tracks.length + changes.length === 0 && <Nothing />}
      <ul>
        {tracks.map(({ cells, size, at_end }, i) => (
          <Item
            key={`t${i}`}
            what={{ list: 'tracks', index: i }}
            label={t('drive.obstacle', {
              number: i + 1,
              size: size ?? 1,
              count: cells.length,
              end: t(`drive.ends.${at_end ?? 'stay'}`),
            })}
            at={cells[0]}
          />
        ))}
        {changes.map(full).map(({ at_step, blocked, freed }, i) => (
          <Item
            key={`c${i}`}
            what={{ list: 'changes', index: i }}
            label={t('drive.walls', {
              step: at_step,
              blocked: blocked.length,
              freed: freed.length,
            })}
            at={blocked[0] ?? freed[0]}
          />
        ))}
      </ul>
      {isNew && <Fields of={hand} />}
      {!isNew && (
        <div class="card-actions">
          <Button
            icon={Route}
            label={t('drive.addObstacle')}
            testId="add-obstacle"
            onClick={() => takeInHand({ list: 'tracks', index: null })}
          />
          <Button
            icon={Blocks}
            label={t('drive.addWalls')}
            testId="add-walls"
            onClick={() => takeInHand({ list: 'changes', index: null })}
          />
        </div>
      )}
      {refusal.value && (
        <p role="alert" class="field-error">
          {failureWords(refusal.value)}
        </p>
      )}
    </section>
  )
}

function Nothing() {
  return (
    <p class="drive-nothing">
      <span>{t('drive.nothing')}</span>
      <Button
        icon={Sparkles}
        label={t('drive.example')}
        testId="drive-example"
        disabled={failure.value !== null}
        onClick={() => void makeExample().catch(notifyError)}
      />
    </p>
  )
}

function takeInHand(what: Edited | null): void {
  refusal.value = null
  edited.value = what
}

function Item({ what, label, at }: { what: Edited; label: string; at: Cell | undefined }) {
  const hand = edited.value
  const inHand = hand?.list === what.list && hand.index === what.index
  const id = `${what.list === 'tracks' ? 'obstacle' : 'walls'}-${(what.index ?? 0) + 1}`
  return (
    <li data-in-hand={inHand}>
      <div class="drive-item">
        <button
          type="button"
          class="button quiet"
          aria-expanded={inHand}
          data-testid={id}
          onClick={() => {
            takeInHand(inHand ? null : what)
            if (!inHand && at) showCell(at)
          }}
        >
          <span>{label}</span>
        </button>
        <IconButton
          icon={Trash2}
          tone="quiet"
          size={15}
          label={t('drive.remove', { what: label })}
          testId={`remove-${id}`}
          onClick={() => remove(what)}
        />
      </div>
      {inHand && <Fields of={what} />}
    </li>
  )
}

function Fields({ of }: { of: Edited }) {
  const isTrack = of.list === 'tracks'
  const own = useRef<HTMLDivElement>(null)
  useEffect(() => own.current?.scrollIntoView({ block: 'nearest' }), [of.index === null])
  return (
    <div ref={own} class="drive-fields">
      {isTrack ? <TrackFields index={of.index} /> : <WallFields index={of.index} />}
      <p class="hint">{t(isTrack ? 'drive.drawTrack' : 'drive.drawWalls')}</p>
      <div class="card-actions">
        <span class="spacer" />
        <Button label={t('drive.done')} testId="drive-done" onClick={() => takeInHand(null)} />
      </div>
    </div>
  )
}
