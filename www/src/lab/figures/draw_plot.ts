/** Draws with the plotting library, and replaces what only a page could resolve, so that the picture stands alone. */
import type { PlotOptions } from '@observablehq/plot'
import { FONT, type Look } from '../../figures/look'
import { element } from '../../figures/svg'
import { numbers } from '../../i18n'
import { axisWords, compact } from '../words/numbers'
import type { Plot, Scene } from './figure'

/** Sizes of a plot's parts in pixels. */
export const MARGIN = { left: 12, right: 18, bottom: 44 }
export const POINT_RADIUS = 2.4
/** The line of an exact optimum. */
export const DOTTED = { strokeWidth: 1.5, strokeDasharray: '1 4', strokeLinecap: 'round' } as const

type Options = Omit<PlotOptions, 'width' | 'height' | 'style'>

export function drawPlot(plot: Plot, scene: Scene, height: number, options: Options): SVGElement {
  const { look, width } = scene
  const { left, right, bottom } = MARGIN
  const drawn = plot.plot({
    width,
    height,
    marginLeft: left,
    marginRight: right,
    marginBottom: bottom,
    ...options,
    style: { fontFamily: FONT, fontSize: '11.5px' },
  })
  const group = element('g', {
    'font-size': 11.5,
    // As the library has it on its own root.
    'text-anchor': 'middle',
    color: look.text,
  })
  drawn.querySelector('style')?.remove()
  group.append(...drawn.children)
  resolve(group, look)
  return group
}

function resolve(group: Element, look: Look): void {
  for (const each of group.querySelectorAll('*')) {
    for (const { name, value } of [...each.attributes]) {
      // The picture as a whole has a label; screen readers need not walk through its parts.
      if (name.startsWith('aria-')) each.removeAttribute(name)
      if (value === 'currentColor') each.setAttribute(name, look.text)
      if (value === 'var(--plot-background)') each.setAttribute(name, look.background)
    }
  }
}

/** The scale of an effort. */
export const effortScale = ({ logarithmic }: Scene) =>
  ({ type: logarithmic ? 'log' : 'linear' }) as const

/** Lines across the plot and numbers below it, as quiet as those of the page's other charts. */
export function gridX(plot: Plot, { look, width }: Scene, label: string) {
  const tickSpacing = Math.max(56, width / 9)
  return [
    plot.gridX({ tickSpacing, stroke: look.line, strokeOpacity: 1 }),
    plot.axisX({ ...LOW, tickSpacing, color: look.muted, label }),
  ]
}

/** The same of an effort, whose lines lie closer where they are logarithmic. */
export function gridEffort(plot: Plot, { analysis, look, width, logarithmic }: Scene) {
  const tickSpacing = logarithmic ? 64 : Math.max(56, width / 9)
  return [
    plot.gridX({ tickSpacing, stroke: look.line, strokeOpacity: 1 }),
    plot.axisX({
      ...LOW,
      // Parts of a second are long numbers.
      tickSpacing: logarithmic && analysis.axis === 'time' ? 110 : tickSpacing,
      color: look.muted,
      label: axisWords(analysis.axis),
      tickFormat: compact,
    }),
  ]
}

/** What stands below a plot. */
export const LOW = { tickSize: 0, labelAnchor: 'center', labelArrow: 'none' } as const

interface Upright {
  label: string
  percent?: boolean
}

export function gridY(plot: Plot, { look }: Scene, { label, percent }: Upright) {
  const tickFormat = percent && ((share: number) => numbers.value.share.format(share))
  return [
    plot.gridY({ tickSpacing: 48, stroke: look.line, strokeOpacity: 1 }),
    plot.axisY({
      tickSpacing: 48,
      tickSize: 0,
      color: look.muted,
      label,
      labelAnchor: 'top',
      labelArrow: 'none',
      ...(tickFormat && { tickFormat }),
    }),
  ]
}
