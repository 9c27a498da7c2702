/** By which scale the panels draw a layer: each by its own, or all by one. */
import { signal } from '@preact/signals'
import type { PanelView } from '../model/messages'
import { recall, remember } from './appearance'

const KEY = 'formicarium.same-scale'

export const sameScale = signal(recall(KEY) === 'yes')
/** Of layers that all panels draw by one scale; kept by `stage/layer_scales.ts`. */
export const layerEnds = signal<PanelView['ends']>({})

export function setSameScale(same: boolean): void {
  sameScale.value = same
  remember(KEY, same ? 'yes' : '')
}
