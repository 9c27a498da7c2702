/** Where a race stops by itself: a set to choose from, and the question at the way to the end. */
import { useSignalEffect } from '@preact/signals'
import { OctagonPause } from 'lucide'
import { useId, useRef } from 'preact/hooks'
import { t } from '../i18n/lesson'
import { COUNTED, MOST_ITERATIONS, STOP_IDS, type Stop, type StopId } from '../model/lesson'
import { askToEnd, lesson, runOn } from '../state'
import { Button, CloseButton } from '../ui/buttons'
import { NumberField } from '../ui/fields'
import { Icon } from '../ui/icon'
import { changeLesson } from './change_lesson'
import { placeBeside } from './popover'

const FIRST_COUNT: Partial<Record<StopId, number>> = { stagnation: 20, iteration: 10 }

export function StopsMenu() {
  const id = useId()
  const button = useRef<HTMLButtonElement>(null)
  const box = useRef<HTMLDivElement>(null)
  useSignalEffect(() => {
    if (askToEnd.value) box.current?.showPopover()
  })
  const toggled = (event: Event) => {
    const open = (event as ToggleEvent).newState === 'open'
    if (!open) askToEnd.value = false
    else if (button.current && box.current) placeBeside(button.current, box.current)
    if (open) box.current?.querySelector<HTMLElement>('.stops-ask button, input')?.focus()
  }
  const count = lesson.value?.stops?.length ?? 0
  const label = count > 0 ? t('lesson.stops.some', { count }) : t('lesson.stops.title')
  return (
    <>
      <button
        ref={button}
        type="button"
        class="icon-button plain stops-button"
        popoverTarget={id}
        aria-label={label}
        aria-pressed={count > 0}
        data-tip={label}
        data-testid="stops"
      >
        <Icon icon={OctagonPause} />
        {count > 0 && (
          <span class="stops-count" aria-hidden="true">
            {count}
          </span>
        )}
      </button>
      <div
        ref={box}
        id={id}
        popover="auto"
        role="dialog"
        aria-label={t('lesson.stops.title')}
        class="menu lesson-box"
        data-testid="stops-box"
        onToggle={toggled}
        // Space and Enter are the box's own while the focus is in it, not the page's.
        onKeyDown={(event) => event.stopPropagation()}
      >
        <header class="lesson-box-head">
          <h3>{t('lesson.stops.title')}</h3>
          <CloseButton
            label={t('lesson.close')}
            testId="stops-close"
            onClick={() => box.current?.hidePopover()}
          />
        </header>
        {askToEnd.value && <Ask done={() => box.current?.hidePopover()} />}
        {STOP_IDS.map((when) => (
          <StopRow key={when} when={when} />
        ))}
        <p class="hint">{t('lesson.stops.note')}</p>
      </div>
    </>
  )
}

/** Running to the end is told apart from running to the next stop by the reader alone. */
function Ask({ done }: { done: () => void }) {
  const run = (through: boolean) => () => {
    done()
    runOn(through)
  }
  return (
    <fieldset class="stops-ask">
      <legend>{t('lesson.stops.ask')}</legend>
      <Button
        label={t('lesson.stops.toStop')}
        tone="primary"
        testId="run-to-stop"
        onClick={run(false)}
      />
      <Button label={t('lesson.stops.through')} testId="run-through" onClick={run(true)} />
    </fieldset>
  )
}

function StopRow({ when }: { when: StopId }) {
  const id = useId()
  const stops = lesson.value?.stops ?? []
  const chosen = stops.find((stop) => stop.when === when)
  const counts = COUNTED.includes(when)
  return (
    <div class="stop-row">
      <label for={id}>
        <input
          id={id}
          type="checkbox"
          checked={chosen !== undefined}
          data-testid={`stop-${when}`}
          onChange={(event) =>
            choose(when, event.currentTarget.checked ? stopOf(when, FIRST_COUNT[when] ?? 1) : null)
          }
        />
        <span>{t(`lesson.stops.names.${when}`)}</span>
      </label>
      {counts && (
        <NumberField
          label={t(when === 'iteration' ? 'lesson.stops.number' : 'lesson.stops.iterations')}
          value={chosen && 'iterations' in chosen ? chosen.iterations : (FIRST_COUNT[when] ?? 1)}
          min={1}
          max={MOST_ITERATIONS}
          step={1}
          nearest
          testId={`stop-${when}-count`}
          onChange={(iterations) => choose(when, stopOf(when, iterations))}
        />
      )}
    </div>
  )
}

function stopOf(when: StopId, iterations: number): Stop {
  return when === 'stagnation' || when === 'iteration' ? { when, iterations } : { when }
}

/** In the order of the menu, whatever is chosen first: the same set is the same link. */
function choose(when: StopId, stop: Stop | null): void {
  const others = (lesson.peek()?.stops ?? []).filter((each) => each.when !== when)
  const all = stop ? [...others, stop] : others
  const sorted = STOP_IDS.flatMap((id) => all.filter((each) => each.when === id))
  changeLesson({ stops: sorted.length > 0 ? sorted : null })
}
