/** One slider for all panels: back through their iterations, and on again. */
import { useSignal, useSignalEffect } from '@preact/signals'
import { ChevronLast, ChevronLeft, ChevronRight, LoaderCircle } from 'lucide'
import { client } from '../engine/panel_clients'
import { numbers } from '../i18n'
import { t } from '../i18n/playback'
import { leavePast, lookedAt, panels, phase } from '../state'
import { madeChanges } from '../state/changing_walls'
import { Button, IconButton } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { lastIteration, lookBy, lookTo, recomputing } from './look_back'

const MIB = 1024 * 1024

export function Scrubber() {
  const last = lastIteration.value
  const at = lookedAt.value ?? last
  const idle = last === 0 || phase.value === 'running'
  const note = useKeptNote()
  return (
    <section
      class="scrubber"
      aria-label={t('playback.region')}
      data-looking={lookedAt.value !== null}
    >
      <IconButton
        icon={ChevronLeft}
        label={t('playback.earlier')}
        keys=","
        tone="quiet"
        testId="look-earlier"
        disabled={idle || at === 0}
        onClick={() => lookBy(-1)}
      />
      <div class="track">
        <input
          class="slider"
          type="range"
          min={0}
          max={Math.max(1, last)}
          step={1}
          value={last === 0 ? 1 : at}
          disabled={idle}
          aria-label={t('playback.slider')}
          aria-valuetext={words()}
          title={note}
          data-testid="scrubber"
          onInput={(event) => lookTo(event.currentTarget.valueAsNumber)}
        />
        <Marks last={last} />
      </div>
      <IconButton
        icon={ChevronRight}
        label={t('playback.later')}
        keys="."
        tone="quiet"
        testId="look-later"
        disabled={idle || lookedAt.value === null}
        onClick={() => lookBy(1)}
      />
      <Where />
    </section>
  )
}

/** Ticks at the iterations after which walls changed, in any panel; the card of the choice says it in words. */
function Marks({ last }: { last: number }) {
  const iterations = new Set(madeChanges.value.flatMap(({ at }) => [...at.values()]))
  const made = [...iterations].filter((iteration) => iteration <= last)
  return (
    <span class="wall-marks" aria-hidden="true" data-testid="changes-of-walls">
      {made.map((iteration) => (
        <span key={iteration} style={{ '--at': iteration / Math.max(1, last) }} />
      ))}
    </span>
  )
}

function words(): string {
  const last = lastIteration.value
  const { whole } = numbers.value
  const iteration = whole.format(lookedAt.value ?? last)
  if (lookedAt.value !== null) return t('playback.at', { iteration, last: whole.format(last) })
  if (last === 0) return t('playback.nothing')
  return t(phase.value === 'running' ? 'playback.running' : 'playback.now', { iteration })
}

function Where() {
  if (lookedAt.value === null) {
    return (
      <span class="where">
        <span class="now in-words">{words()}</span>
        <InShort />
      </span>
    )
  }
  return (
    <span class="where">
      <span class="chip looking" role="status" data-testid="looking-back">
        <span class="in-words">{words()}</span>
        <InShort />
      </span>
      <Button
        icon={ChevronLast}
        label={t('playback.backToNow')}
        testId="back-to-now"
        onClick={leavePast}
      />
      <span class="recomputing" data-busy={recomputing.value}>
        <span class="spinner">
          <Icon icon={LoaderCircle} size={16} />
        </span>
        <span class="visually-hidden">{recomputing.value ? t('playback.recomputing') : ''}</span>
      </span>
    </span>
  )
}

/** The words where there is no room for them. */
function InShort() {
  const last = lastIteration.value
  return (
    <span class="in-short" aria-hidden="true">
      {last === 0 ? '–' : `${lookedAt.value ?? last} / ${last}`}
    </span>
  )
}

/** How much is kept to look back and, while nothing runs, how much memory that takes. */
function useKeptNote(): string {
  const kept = useSignal('')
  useSignalEffect(() => {
    kept.value = ''
    const resting = phase.value === 'paused' || phase.value === 'finished'
    if (resting && lastIteration.value > 0)
      void keptNow().then((note) => {
        kept.value = note
      })
  })
  return `${t('playback.kept')} ${kept.value}`
}

async function keptNow(): Promise<string> {
  const asked = panels.peek().map(({ id }) => client(id)?.ask({ about: 'kept' }))
  const all = (await Promise.all(asked)).filter((kept) => kept != null)
  if (all.length === 0) return ''
  const { whole, metres } = numbers.peek()
  return t('playback.keptNow', {
    snapshots: whole.format(all.reduce((sum, { snapshots }) => sum + snapshots, 0)),
    size: metres.format(all.reduce((sum, { bytes }) => sum + bytes, 0) / MIB),
    repeated: whole.format(Math.max(...all.map(({ mostRepeated }) => mostRepeated))),
  })
}

/** A mark beside numbers of the past. */
export function PastChip() {
  const iteration = lookedAt.value
  if (iteration === null) return null
  return (
    <span class="chip looking" data-testid="numbers-of">
      {t('playback.ofIteration', { iteration: numbers.value.whole.format(iteration) })}
    </span>
  )
}
