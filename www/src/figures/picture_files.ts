/** Pictures as files: SVG that stands alone, PNG drawn from it. */
import { download } from '../state/export_files'
import { svgText } from './svg'

export const downloadSvg = (svg: SVGSVGElement, stem: string): void =>
  download(`${stem}.svg`, svgText(svg), 'image/svg+xml')

export async function savePng(png: Blob, stem: string): Promise<void> {
  download(`${stem}.png`, new Uint8Array(await png.arrayBuffer()), 'image/png')
}

/** A PNG with this many pixels for each of the SVG's. */
export async function figurePng(svg: SVGSVGElement, scale: number): Promise<Blob> {
  const url = URL.createObjectURL(new Blob([svgText(svg)], { type: 'image/svg+xml' }))
  try {
    const image = new Image()
    image.src = url
    await image.decode()
    const canvas = document.createElement('canvas')
    canvas.width = Math.round(svg.width.baseVal.value * scale)
    canvas.height = Math.round(svg.height.baseVal.value * scale)
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height)
    return await blobOf(canvas)
  } finally {
    URL.revokeObjectURL(url)
  }
}

export function blobOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('the picture is too large'))),
      'image/png',
    )
  })
}
