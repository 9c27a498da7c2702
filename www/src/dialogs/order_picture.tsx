/** The places, the best tour so far and, where asked for, the trails. */
import type { OrderFacts } from '@pkg/formicarium'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import { theme } from '../state'
import type { OrderPlay, ShownTour } from '../state/order_play'
import { Select } from '../ui/fields'

type Spot = readonly [number, number]

/** Part of the side that stays free around the places. */
const MARGIN = 0.05

export function OrderPicture({ play }: { play: OrderPlay }) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const facts = play.facts.value
  const [trails, ink] = [play.trails.value, theme.value]
  const { open } = play.settings.value
  const order = orderOn(play)
  useEffect(() => {
    const canvasNow = canvas.current
    if (!canvasNow) return
    const draw = () => {
      const surface = surfaceOf(canvasNow)
      if (!surface) return
      const spots = spotsOf(facts)
      if (trails) surface.trails(spots, trails)
      if (order) surface.tour(spots, order, open)
      surface.places(spots)
    }
    draw()
    // It has no size before its dialog is open.
    const sizes = new ResizeObserver(draw)
    sizes.observe(canvasNow)
    return () => sizes.disconnect()
  }, [facts, order, trails, ink, open])
  return (
    <>
      <canvas
        ref={canvas}
        class="order-picture"
        role="img"
        aria-label={t('order.picture', { count: facts.places })}
        data-testid="order-picture"
      />
      <TourChoice play={play} />
      <label class="order-trails">
        <input
          type="checkbox"
          data-testid="order-trails"
          checked={trails !== null}
          onChange={() => play.toggleTrails()}
        />
        {t('order.trails')}
      </label>
      {facts.at === null && <p class="hint">{t('order.onCircle')}</p>}
    </>
  )
}

/** The tours that can be drawn, or will be. */
function toursOf(play: OrderPlay): ShownTour[] {
  const { tour, exact } = play.facts.value
  const known = { ants: true, tour, exact, search: exact === null }
  return (Object.keys(known) as ShownTour[]).filter((tour) => known[tour])
}

/** The order that is drawn; null while the ants have none. */
function orderOn(play: OrderPlay): number[] | null {
  const { tour, exact } = play.facts.value
  const best = play.summary.value?.best ?? null
  const search = play.bound.value?.best ?? null
  const chosen = { ants: best, tour, exact, search }[play.shown.value] ?? best
  return chosen?.order ?? null
}

function TourChoice({ play }: { play: OrderPlay }) {
  const tours = toursOf(play)
  if (tours.length === 1) return null
  const labels: Record<ShownTour, string> = {
    ants: t('order.best'),
    tour: t('order.tour', { file: play.tour?.name ?? '' }),
    exact: t('order.shownExact'),
    search: t('order.search'),
  }
  return (
    <Select
      class="order-shown"
      label={t('order.shownTour')}
      value={tours.includes(play.shown.value) ? play.shown.value : 'ants'}
      options={tours.map((value) => ({
        value,
        label: labels[value],
        disabled: value === 'search' && play.bound.value === null,
      }))}
      testId="order-shown"
      onChange={(value) => {
        play.shown.value = value
      }}
    />
  )
}

/** Places in a square from 0 to 1, y downwards; on a circle where nobody knows where they are. */
function spotsOf({ at, places }: OrderFacts): Spot[] {
  if (at === null)
    return Array.from({ length: places }, (_, i) => {
      const turn = (2 * Math.PI * i) / places
      return [0.5 + 0.5 * Math.sin(turn), 0.5 - 0.5 * Math.cos(turn)] as const
    })
  const [left, bottom] = [0, 1].map((axis) => Math.min(...at.map((p) => p[axis] ?? 0))) as [
    number,
    number,
  ]
  const [right, top] = [0, 1].map((axis) => Math.max(...at.map((p) => p[axis] ?? 0))) as [
    number,
    number,
  ]
  const size = Math.max(right - left, top - bottom) || 1
  const x = (size - (right - left)) / 2
  const y = (size - (top - bottom)) / 2
  return at.map((p) => [(p[0] - left + x) / size, 1 - (p[1] - bottom + y) / size] as const)
}

/** A canvas as sharp as the screen. */
function surfaceOf(canvas: HTMLCanvasElement) {
  const context = canvas.getContext('2d')
  const side = canvas.clientWidth
  if (!context || side === 0) return null
  const scale = devicePixelRatio || 1
  canvas.width = canvas.height = Math.round(side * scale)
  context.scale(scale, scale)
  context.lineJoin = context.lineCap = 'round'
  const style = getComputedStyle(canvas)
  const colour = (name: string) => style.getPropertyValue(name).trim()
  const on = (share: number) => side * (MARGIN + (1 - 2 * MARGIN) * share)
  const line = (spots: (Spot | undefined)[], close: boolean) => {
    context.beginPath()
    for (const spot of spots) if (spot) context.lineTo(on(spot[0]), on(spot[1]))
    if (close) context.closePath()
    context.stroke()
  }
  return {
    trails(spots: Spot[], trails: Float64Array) {
      context.strokeStyle = colour('--info')
      context.lineWidth = 4
      for (let i = 0; i + 2 < trails.length; i += 3) {
        context.globalAlpha = 0.08 + 0.5 * (trails[i + 2] ?? 0)
        line([spots[trails[i] ?? 0], spots[trails[i + 1] ?? 0]], false)
      }
      context.globalAlpha = 1
    },
    tour(spots: Spot[], order: number[], open: boolean) {
      context.strokeStyle = colour('--accent')
      context.lineWidth = 1.75
      line(
        order.map((place) => spots[place]),
        !open,
      )
    },
    places(spots: Spot[]) {
      const radius = spots.length > 200 ? 1.75 : 3.5
      spots.forEach(([x, y], place) => {
        context.fillStyle = colour(place === 0 ? '--start' : '--text')
        context.beginPath()
        context.arc(on(x), on(y), place === 0 ? radius + 2.5 : radius, 0, 2 * Math.PI)
        context.fill()
      })
    },
  }
}
