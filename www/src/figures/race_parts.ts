/** What every picture of the race is made of: who runs, what they have reached, and in which colours it is drawn. */
import { numbers } from '../i18n'
import { t } from '../i18n/pictures'
import { lookedAt, type Panel, panels, scenario, seed, shownOf, slotColour, theme } from '../state'
import { gapShown, panelGap } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { panelTitle } from '../words/planner_words'
import type { Drawing, Heading } from './frame'
import { LOOKS, type Look } from './look'

/** As on the page, or on white paper. */
export type Ground = 'page' | 'print'

/** Pixels: as wide as a page of a paper at 96 dots an inch, less its margins. */
export const WIDTH = 720

export interface Picture {
  drawing: Drawing
  heading: Heading
  /** For screen readers. */
  words: string
  look: Look
}

export const themeOf = (ground: Ground) => (ground === 'print' ? 'light' : theme.peek())
export const lookOf = (ground: Ground): Look => LOOKS[themeOf(ground)]

export interface Runner {
  panel: Panel
  colour: string
  name: string
  /** x0, y0, x1, y1, …; null while there is none. */
  path: Uint32Array | null
  altitudes: Float64Array | null
  /** Name, length and gap. */
  label: string
}

export function runners(): Runner[] {
  return panels.peek().map((panel) => {
    const { summary, bestPath, bestAltitudes } = shownOf(panel)
    const name = panelTitle(panel.id)
    const path = bestPath && bestPath.length > 0 ? bestPath : null
    const gap = panelGap(panel)
    const length = summary?.metrics?.length
    const label =
      length === undefined
        ? t(summary?.status === 'no-path' ? 'pictures.noPath' : 'pictures.noPathYet', { name })
        : t(gap === null ? 'pictures.withLength' : 'pictures.withGap', {
            name,
            length: lengthShown(length),
            gap: gap === null ? '' : gapShown(gap),
          })
    return { panel, colour: slotColour(panel.slot), name, path, altitudes: bestAltitudes, label }
  })
}

/** What is shown, of which map, seed and iteration. */
export function headingOf(what: string): Heading {
  const name = scenario.peek()?.spec.name ?? ''
  const { whole } = numbers.peek()
  const parts = [
    t('pictures.seed', { seed: seed.peek() }),
    t('pictures.iteration', { iteration: whole.format(iterationShown()) }),
  ]
  return { title: name === '' ? what : `${name} · ${what}`, subtitle: parts.join(' · ') }
}

/** The one that is looked back at, or the last one that a run has reached. */
function iterationShown(): number {
  const reached = panels.peek().map((panel) => shownOf(panel).summary?.iteration ?? 0)
  return lookedAt.peek() ?? Math.max(0, ...reached)
}
