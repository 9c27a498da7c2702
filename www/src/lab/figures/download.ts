/** Figures as files, with their typeface inside. */

import { framed, type Heading } from '../../figures/frame'
import { type Ground, LOOKS } from '../../figures/look'
import { figurePng, savePng } from '../../figures/picture_files'
import { element } from '../../figures/svg'
import { inSentences } from '../../i18n/lists'
import fontUrl from '../../styles/figtree-basic.woff2?url'
import type { Figure, Plot, Scene } from './figure'

/** Pixels: as wide as a page of a paper at 96 dots an inch, less its margins. */
const FILE_WIDTH = 720
/** Pixels of a PNG for each of the SVG's. */
const PNG_SCALE = 2

/** Embeds the comparison in a picture. */
type Embed = (png: Blob) => Promise<Blob>

let embed: Embed | null = null

/** From now on `how` embeds the comparison in every PNG. */
export function embedInPictures(how: Embed | null): void {
  embed = how
}

/** The figure as a file: with its heading, on the chosen background, in a size that does not depend on the screen. */
export async function figureFile(
  plot: Plot,
  figure: Figure,
  scene: Scene,
  heading: Heading,
  ground: Ground,
): Promise<SVGSVGElement> {
  const look = LOOKS[ground]
  const own = { ...scene, look, width: FILE_WIDTH }
  const words = inSentences([heading.title, heading.subtitle, figure.words(own)])
  const svg = framed(figure.draw(plot, own), FILE_WIDTH, look, words, heading)
  svg.prepend(element('style', {}, await fontFace()))
  return svg
}

export async function downloadPng(svg: SVGSVGElement, stem: string): Promise<void> {
  const drawn = await figurePng(svg, PNG_SCALE)
  await savePng(embed ? await embed(drawn) : drawn, stem)
}

let face: Promise<string> | null = null

/** The page's typeface inside the picture: pictures in pictures reach no file beside them. */
function fontFace(): Promise<string> {
  face ??= fetch(fontUrl)
    .then((answer) => answer.arrayBuffer())
    .then((bytes) => {
      const data = btoa(String.fromCharCode(...new Uint8Array(bytes)))
      return `@font-face{font-family:"Figtree Variable";font-weight:300 900;src:url(data:font/woff2;base64,${data}) format("woff2")}`
    })
  return face.catch((error) => {
    face = null
    throw error
  })
}
