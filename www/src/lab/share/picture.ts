/** Pictures that carry the open study: dropped on the page, it is there again. */
import { pngWith } from '../../share/png'
import { resultFile } from '../run/actions'

/** Beyond so many characters of runs, a picture carries their digests alone, as a link does. */
const MOST_TEXT = 32 * 1024 * 1024

export async function withStudy(picture: Blob): Promise<Blob> {
  const whole = await resultFile('json')
  const text = whole.length > MOST_TEXT ? await resultFile('link') : whole
  const png = await pngWith(new Uint8Array(await picture.arrayBuffer()), text)
  return new Blob([png], { type: 'image/png' })
}
