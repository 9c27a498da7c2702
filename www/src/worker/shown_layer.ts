/** Paints what a run shows: the layer that was chosen, or what there is in its place. */
import type { Run } from '@pkg/core/formicarium'
import type { Layer } from '@pkg/formicarium'
import type { LayerScale, PanelView } from '../model/messages'

type Look = Pick<PanelView, 'layer' | 'ends' | 'theme'>

/** Gives what the colours say. */
export function paintLayer(
  run: Run,
  context: OffscreenCanvasRenderingContext2D,
  { layer: wanted, ends, theme }: Look,
  shaded: boolean,
): LayerScale {
  const layer = layerOf(run, wanted)
  const common = layer === 'none' ? null : ends[layer]
  const [low, high] = run.paint(context, layer, theme, shaded, common)
  return { layer, own: low === undefined || high === undefined ? null : [low, high] }
}

/** Stays the same as long as `paintLayer` would paint the same picture. */
export function pictureOf(run: Run, { layer: wanted, ends, theme }: Look): string {
  const layer = layerOf(run, wanted)
  return `${run.moment(layer)} ${layer} ${ends[layer as Layer]} ${theme}`
}

/** One layer is chosen for all panels; a planner without it shows the first it has. */
function layerOf(run: Run, wanted: Layer | 'none'): Layer | 'none' {
  if (wanted === 'none') return 'none'
  const layers = run.layers()
  return layers.includes(wanted) ? wanted : (layers[0] ?? 'none')
}
