/** Embeds the open comparison in a picture: dropped on the page, the picture opens it. */
import { pngWith } from '../../share/png'
import { resultFile } from '../run/actions'

/** With more characters of runs than this, a picture has only their digests, as a link does. */
const MOST_TEXT = 32 * 1024 * 1024

export async function embedComparison(picture: Blob): Promise<Blob> {
  const whole = await resultFile('json')
  const text = whole.length > MOST_TEXT ? await resultFile('link') : whole
  const png = await pngWith(new Uint8Array(await picture.arrayBuffer()), text)
  return new Blob([png], { type: 'image/png' })
}
