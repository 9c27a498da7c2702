/** The pictures that a race can be taken away as. */
import { addPictureWords } from '../i18n/pictures'
import { addReadingWords } from '../i18n/reading'
import { fileStem } from '../state/export_files'
import type { PictureKind } from '../state/pictures'
import { onTerrain } from '../state/relief'
import { convergencePicture } from './convergence_picture'
import { framed } from './frame'
import { mapPicture, type Whose } from './map_picture'
import { downloadSvg, figurePng, savePng } from './picture_files'
import { profilePicture } from './profile_picture'
import { type Ground, type Picture, WIDTH } from './race_parts'

export const picturesReady = () => Promise.all([addPictureWords(), addReadingWords()])

/** Those that the present map has. */
export const pictureKinds = (): PictureKind[] =>
  onTerrain.value ? ['map', 'convergence', 'profile'] : ['map', 'convergence']

export interface Wanted {
  kind: PictureKind
  whose: Whose
  ground: Ground
}

/** Null where there is nothing to draw yet. */
export async function pictureOf({ kind, whose, ground }: Wanted): Promise<SVGSVGElement | null> {
  const picture = await drawn(kind, whose, ground)
  return picture && framed(picture.drawing, WIDTH, picture.look, picture.words, picture.heading)
}

async function drawn(kind: PictureKind, whose: Whose, ground: Ground): Promise<Picture | null> {
  if (kind === 'convergence') return convergencePicture(ground)
  return kind === 'profile' ? profilePicture(ground) : mapPicture(ground, whose)
}

const stemOf = (kind: PictureKind) => `${fileStem()}-${kind}`

export const saveSvg = (svg: SVGSVGElement, kind: PictureKind) => downloadSvg(svg, stemOf(kind))

/** With so many pixels for each of the SVG's. */
export const savePngOf = async (svg: SVGSVGElement, kind: PictureKind, scale: number) =>
  savePng(await figurePng(svg, scale), `${stemOf(kind)}@${scale}x`)
