/** A panel of its own: where one run has laid more pheromone than another. */
import { useComputed, useSignal } from '@preact/signals'

import { useEffect, useRef } from 'preact/hooks'
import { language } from '../i18n'
import { t } from '../i18n/playback'
import { watchSize } from '../stage/element_size'
import { sendOnceAFrame } from '../stage/once_a_frame'
import type { CanvasSize, Cursor } from '../stage/panel_view'
import { comparing, scenario, theme } from '../state'
import { CloseButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { panelTitle } from '../words/planner_words'
import { chosen, differenceAt, keepComparing, pair, trails, withTrails } from './difference'
import { scaleGradient } from './difference_map'
import { DifferenceStage } from './difference_stage'

export function DifferencePanel() {
  useEffect(keepComparing, [])
  const host = useRef<HTMLDivElement>(null)
  const size = useSignal<CanvasSize>({ width: 1, height: 1, dpr: 1 })
  const cursor = useSignal<Cursor | null>(null)
  const both = pair.value
  const label = useComputed(() => {
    const spec = scenario.value?.spec
    const now = pair.value
    if (!spec || !now) return t('playback.difference.title')
    const [a, b] = now.map(({ id }) => panelTitle(id))
    return t('playback.difference.label', { a, b, width: spec.width, height: spec.height })
  })
  useEffect(() => {
    const element = host.current
    if (element === null) return
    const stopMeasuring = watchSize(element, (measured) => {
      size.value = measured
    })
    const stage = new DifferenceStage(element, size, cursor)
    const stopDrawing = sendOnceAFrame(
      () => stage.picture(),
      (picture) => stage.draw(picture),
    )
    return () => {
      stopDrawing()
      stage.release()
      stopMeasuring()
    }
  }, [])
  return (
    <article
      class="panel difference"
      aria-label={t('playback.difference.title')}
      data-testid="difference"
    >
      <header class="panel-head">
        <h2>{t('playback.difference.title')}</h2>
        <span class="spacer" />
        <CloseButton
          label={t('playback.difference.close')}
          testId="close-difference"
          onClick={() => {
            comparing.value = false
          }}
        />
      </header>
      {both && (
        <div class="pair">
          <Choice which={0} />
          <span class="versus">−</span>
          <Choice which={1} />
        </div>
      )}
      <div class="panel-stage">
        <div
          ref={host}
          class="stage"
          data-testid="stage-difference"
          data-tool="pan"
          role="application"
          aria-label={label}
          // biome-ignore lint/a11y/noNoninteractiveTabindex: an application region is operated with the keyboard
          tabIndex={0}
        />
        <Empty />
      </div>
      <Legend cursor={cursor.value} />
    </article>
  )
}

function Empty() {
  if (pair.value && trails.value) return null
  return (
    <p class="difference-empty" role="status" data-testid="difference-empty">
      {t(pair.value ? 'playback.difference.wait' : 'playback.difference.needTwo')}
    </p>
  )
}

/** The other one of the pair trades places with what is chosen twice. */
function Choice({ which }: { which: 0 | 1 }) {
  const both = pair.value
  const own = both?.[which].id
  const other = both?.[1 - which]?.id ?? null
  const letter = which === 0 ? 'a' : 'b'
  return (
    <Select
      label={t(`playback.difference.${letter}`)}
      hideLabel
      class="difference-select"
      value={String(own)}
      testId={`difference-${letter}`}
      options={withTrails.value.map(({ id }) => ({
        value: String(id),
        label: `${letter.toUpperCase()}: ${panelTitle(id)}`,
      }))}
      onChange={(value) => {
        const id = Number(value)
        const rest = id === other ? (own ?? null) : other
        chosen.value = which === 0 ? [id, rest] : [rest, id]
      }}
    />
  )
}

function Legend({ cursor }: { cursor: Cursor | null }) {
  const now = trails.value
  return (
    <footer class="difference-legend">
      <div class="scale" title={t('playback.difference.scale')}>
        <span>{t('playback.difference.bStronger')}</span>
        <span class="ramp">
          <span class="colours" style={{ background: scaleGradient(theme.value) }} />
          <span class="ticks" aria-hidden="true">
            {['−1', '−0.5', '0', '0.5', '1'].map((tick) => (
              <span key={tick}>{tick}</span>
            ))}
          </span>
        </span>
        <span>{t('playback.difference.aStronger')}</span>
      </div>
      <p class="hint" data-testid="difference-normalised">
        {now &&
          t('playback.difference.normalised', {
            a: now.ranges.map(rangeWords)[0],
            b: now.ranges.map(rangeWords)[1],
          })}
      </p>
      <p
        class="values"
        data-testid="difference-values"
        data-iterations={now?.iterations.join()}
        role="status"
      >
        {valuesAt(cursor) ?? t('playback.difference.hint')}
      </p>
    </footer>
  )
}

/** Both trails at the cell under the pointer or the cursor. */
function valuesAt(cursor: Cursor | null): string | null {
  const now = trails.value
  const spec = scenario.value?.spec
  if (!now || !spec || !cursor) return null
  const [x, y] = cursor.cell
  const cell = y * spec.width + x
  const difference = differenceAt(now, cell)
  return `${t('playback.difference.cell', { x, y })} ${t('playback.difference.values', {
    a: quantity(now.a[cell] ?? 0),
    b: quantity(now.b[cell] ?? 0),
    difference: signed(difference),
  })}`
}

const rangeWords = ({ weakest, strongest }: { weakest: number; strongest: number }) =>
  `${quantity(weakest)}–${quantity(strongest)}`

const quantity = (value: number) =>
  new Intl.NumberFormat(language.value, {
    maximumSignificantDigits: 3,
    notation: value !== 0 && (value < 1e-3 || value >= 1e5) ? 'scientific' : 'standard',
  }).format(value)

const signed = (value: number) =>
  new Intl.NumberFormat(language.value, {
    minimumFractionDigits: 2,
    maximumFractionDigits: 2,
    signDisplay: 'exceptZero',
  }).format(value)
