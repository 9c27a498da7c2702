/** How a terrain is looked at: from above or in three dimensions, with or without contour lines. All panels alike. */
import { computed, signal } from '@preact/signals'
import { t } from '../i18n'
import { fitView, zoomBy } from '../model/viewpoint'
import { lazyParts, type ReliefPart } from './lazy_parts'
import { announce, notify, notifyError } from './notices'
import { scenario } from './store'

export const showContours = signal(true)

/** Drawing in three dimensions is fetched when it is first asked for. */
export const relief = signal<ReliefPart | null>(null)
const wanted = signal(false)

export const onTerrain = computed(() => (scenario.value?.heights ?? null) !== null)
export const inRelief = computed(() => wanted.value && onTerrain.value && relief.value !== null)

export async function showRelief(on: boolean): Promise<void> {
  wanted.value = on
  if (!on || !onTerrain.peek()) return
  // Whoever asks for it is told once for all that there is none: browsers log each try.
  if (!canDraw()) return leaveRelief('missing')
  try {
    relief.value ??= await lazyParts.relief()
    announce(t('relief.opened'))
  } catch (error) {
    wanted.value = false
    notifyError(error)
  }
}

/** Whether the browser has WebGL; asked for once. */
let drawable: boolean | null = null
function canDraw(): boolean {
  drawable ??= new OffscreenCanvas(1, 1).getContext('webgl2') !== null
  return drawable
}

/** On a plane there is nothing to see in three dimensions. */
export function toggleRelief(): void {
  if (onTerrain.peek()) void showRelief(!wanted.peek())
}

/** The browser cannot draw it, or not any more; the view from above needs nothing of it. */
export function leaveRelief(why: 'missing' | 'lost'): void {
  if (!wanted.peek()) return
  wanted.value = false
  notify('warning', t(`relief.${why}`), { hint: t(`relief.${why}Hint`) })
}

/** For buttons: whichever view is on screen. */
export function zoomView(factor: number): void {
  if (inRelief.peek()) relief.peek()?.zoomEye(factor)
  else zoomBy(factor)
}

export function fitWholeMap(): void {
  if (inRelief.peek()) relief.peek()?.resetEye()
  else fitView()
}
