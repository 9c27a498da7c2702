/** Reads QR codes by a library that has nothing to do with the one that makes them. */
import type { Page } from '@playwright/test'
import jsQR from 'jsqr'

interface Drawn {
  width: number
  height: number
  /** As base64. */
  pixels: string
}

/** The text of the code in a picture; null where there is none. */
export function textOfCode({ width, height, pixels }: Drawn): string | null {
  const bytes = new Uint8ClampedArray(Buffer.from(pixels, 'base64'))
  return jsQR(bytes, width, height)?.data ?? null
}

/** What is on the first canvas or picture that a selector finds, enlarged so many times, on a page without a policy of its own. */
export async function drawnPixels(page: Page, selector: string, scale = 1): Promise<Drawn> {
  return page.locator(selector).evaluate((shown, times) => {
    const from = shown as HTMLCanvasElement | HTMLImageElement | HTMLVideoElement
    const size = (side: 'width' | 'height') => {
      if (from instanceof HTMLImageElement)
        return side === 'width' ? from.naturalWidth : from.naturalHeight
      if (from instanceof HTMLVideoElement)
        return side === 'width' ? from.videoWidth : from.videoHeight
      return from[side]
    }
    const canvas = document.createElement('canvas')
    const [width, height] = [times * size('width'), times * size('height')]
    Object.assign(canvas, { width, height })
    const context = canvas.getContext('2d')
    context?.drawImage(from, 0, 0, width, height)
    const { data } = context?.getImageData(0, 0, width, height) ?? { data: new Uint8ClampedArray() }
    let text = ''
    for (let i = 0; i < data.length; i += 8192)
      text += String.fromCharCode(...data.subarray(i, i + 8192))
    return { width, height, pixels: btoa(text) }
  }, scale)
}
