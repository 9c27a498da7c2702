/** What all live charts look like: the page's colours and type, quiet axes, no legend. */
import type uPlot from 'uplot'

export interface ChartLook {
  /** A colour of the page by its custom property. */
  colour(name: string): string
  axis: uPlot.Axis
  /** Size and what is left out. */
  frame: Pick<uPlot.Options, 'width' | 'height' | 'legend'>
}

export function chartLook(host: HTMLElement): ChartLook {
  const style = getComputedStyle(host)
  const colour = (name: string) => style.getPropertyValue(name).trim()
  const font = `11px ${style.fontFamily}`
  return {
    colour,
    axis: {
      stroke: colour('--text-muted'),
      font,
      grid: { stroke: colour('--line'), width: 1 },
      ticks: { show: false },
      gap: 6,
      labelFont: font,
      labelSize: 16,
      labelGap: 0,
    },
    frame: { ...sizeOf(host), legend: { show: false } },
  }
}

/** Keeps a plot, whichever there is now, as large as its host, until it is stopped. `resized`: what else follows. */
export function keepFitting(
  host: HTMLElement,
  plot: () => uPlot | null,
  resized: () => void,
): () => void {
  const observer = new ResizeObserver(() => {
    plot()?.setSize(sizeOf(host))
    resized()
  })
  observer.observe(host)
  return () => observer.disconnect()
}

const sizeOf = ({ clientWidth, clientHeight }: HTMLElement) => ({
  width: Math.max(1, clientWidth),
  height: Math.max(1, clientHeight),
})
