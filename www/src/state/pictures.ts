/** Which picture of the race is to be taken away. */
import { signal } from '@preact/signals'
import { show } from './dialogs'

export type PictureKind = 'map' | 'convergence' | 'profile'

/** What the dialog begins with. */
export const wantedPicture = signal<PictureKind>('map')

export function takePicture(kind: PictureKind): void {
  wantedPicture.value = kind
  show('picture')
}
