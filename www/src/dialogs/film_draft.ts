/** What the reader has chosen for a film, a moving picture or slides, and what follows from it. */
import { STEPS, type StepSettings } from '../film/make_steps'
import {
  evenSize,
  type Filmed,
  type FilmSettings,
  type FilmSize,
  framesOf,
  SIZES,
  speedFor,
  type Unit,
} from '../film/settings'
import { latest, layer, panels, theme } from '../state'
import { isSearch } from '../words/planner_words'

export type What = 'film' | 'steps' | 'slides'

export interface Draft extends Omit<FilmSettings, 'panels'> {
  what: What
  /** One of the sizes offered, or −1 for an own one. */
  offer: number
  /** As the runs stood when the dialog was opened: they may go on behind it. */
  filmed: Filmed[]
  whose: number | 'all'
  steps: number
  spread: StepSettings['spread']
}

/** As long as a film is at first. */
const SECONDS = 16
/** Where no run has begun, and none has a budget. */
const FEW_ITERATIONS = 50
const WALK = { last: 240, perSecond: 12 }
const STEPS_AT_FIRST = 8

/** As the race stands and looks. */
export function firstDraft(): Draft {
  const [size = { width: 1280, height: 720 }] = SIZES
  const look = { layer: layer.peek(), theme: theme.peek() }
  const filmed = panels.peek().map(({ id }): Filmed => {
    const { summary } = latest(id)
    if (!summary || summary.iteration === 0) return { id, reached: null }
    const { iteration, digest } = summary
    return { id, reached: { iteration, digest } }
  })
  const others = { filmed, steps: STEPS_AT_FIRST, spread: 'even' as const, whose: 'all' as const }
  return withUnit({ what: 'film', offer: 0, ...size, rate: 30, ...look, ...others }, 'iteration')
}

/** Iterations up to where the runs stand or, where none has begun, to their end; moves as many as are a short walk. */
export function withUnit(draft: Omit<Draft, 'unit' | 'last' | 'perSecond'>, unit: Unit): Draft {
  if (unit === 'move') return { ...draft, unit, ...WALK }
  const last = lastIteration()
  const perSecond = rounded(speedFor(SECONDS, { last, rate: draft.rate }))
  return { ...draft, unit, last, perSecond }
}

function lastIteration(): number {
  const known = panels.peek().flatMap(({ id, setup }) => {
    const { summary } = latest(id)
    return summary ? [{ summary, search: isSearch(setup.planner) }] : []
  })
  const colonies = known.filter(({ search }) => !search)
  const counted = (colonies.length > 0 ? colonies : known).map(({ summary }) => summary)
  const reached = Math.max(0, ...counted.map(({ iteration }) => iteration))
  if (reached > 0) return reached
  const budget = Math.max(0, ...counted.map(({ iteration_budget }) => iteration_budget ?? 0))
  return budget > 0 ? budget : FEW_ITERATIONS
}

/** As it is shown: whole numbers where they are large. */
export const rounded = (value: number) =>
  value >= 10 ? Math.round(value) : Math.max(0.1, Math.round(10 * value) / 10)

export function withOffer(draft: Draft, offer: number): Draft {
  return { ...draft, offer, ...(SIZES[offer] ?? evenSize(draft)) }
}

export const withSide = (draft: Draft, side: Partial<FilmSize>): Draft => ({
  ...draft,
  ...evenSize({ ...draft, ...side }),
})

const shown = ({ whose, filmed }: Draft) =>
  filmed.filter(({ id }) => whose === 'all' || id === whose)

export function filmOf(draft: Draft): FilmSettings {
  const { width, height, rate, unit, last, perSecond, layer: seen, theme: colours } = draft
  const look = { width, height, layer: seen, theme: colours, panels: shown(draft) }
  return { ...look, rate, unit, last, perSecond }
}

export function stepsOf(draft: Draft): StepSettings {
  const { width, height, last, steps, spread, layer: seen, theme: colours } = draft
  const look = { width, height, layer: seen, theme: colours, panels: shown(draft) }
  return { ...look, last, steps, spread, as: draft.what === 'slides' ? 'slides' : 'steps' }
}

/** A film for steps too: its first and last frame show what they begin and end with. */
export const previewOf = (draft: Draft, first: boolean) => {
  const settings = filmOf(draft)
  return { settings, frame: first ? 0 : framesOf(settings) - 1 }
}

export const LIMITS = { steps: STEPS, last: { least: 1, most: 1_000_000 } }
