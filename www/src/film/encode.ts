/** Frames to a video file, by what the browser can encode. The library for it is fetched with the first film. */
import type { VideoCodec } from 'mediabunny'
import { GrowingFile } from './growing_file'
import type { FilmSize } from './settings'

export interface Encoding {
  codec: VideoCodec
  ending: 'mp4' | 'webm'
  /** As people call it. */
  name: string
}

/** What most programs play comes first; WebM where the browser does not encode that. */
const OFFERS: readonly Encoding[] = [
  { codec: 'avc', ending: 'mp4', name: 'MP4 (H.264)' },
  { codec: 'vp9', ending: 'webm', name: 'WebM (VP9)' },
  { codec: 'vp8', ending: 'webm', name: 'WebM (VP8)' },
  { codec: 'av1', ending: 'webm', name: 'WebM (AV1)' },
]

/** Bits a pixel and frame: lines and letters must stay sharp, and most of a map stands still. */
const BITS_PER_PIXEL = 0.12
const LEAST_BITRATE = 800_000
/** Parts of the file are handed on when they are so large. */
const CHUNK_BYTES = 1 << 20

export const bitrateOf = ({ width, height }: FilmSize, rate: number) =>
  Math.max(LEAST_BITRATE, Math.round(width * height * rate * BITS_PER_PIXEL))

/** The first of the encodings that the browser has for frames of this size; null where it has none. */
export async function encodingFor(size: FilmSize, rate: number): Promise<Encoding | null> {
  if (typeof VideoEncoder === 'undefined') return null
  const { canEncodeVideo, Quality } = await import('./encoder')
  const quality = new Quality({ bitrate: bitrateOf(size, rate) })
  for (const offer of OFFERS)
    if (await canEncodeVideo(offer.codec, { ...size, quality })) return offer
  return null
}

export interface Tags {
  title: string
  /** The link, by which the page opens the race of a film. */
  comment: string
}

export interface FilmFile {
  /** The canvas as it is becomes the frame of this number; resolves when the next may come. */
  add(frame: number): Promise<void>
  finish(): Promise<Blob>
  /** Nothing is left of it. */
  drop(): Promise<void>
}

/** A file for the frames of a canvas. */
export async function newFilm(
  canvas: OffscreenCanvas,
  { codec, ending }: Encoding,
  rate: number,
  tags: Tags,
): Promise<FilmFile> {
  const { CanvasSource, Mp4OutputFormat, Output, Quality, StreamTarget, WebMOutputFormat } =
    await import('./encoder')
  const file = new GrowingFile()
  const source = new CanvasSource(canvas, {
    codec,
    quality: new Quality({ bitrate: bitrateOf(canvas, rate) }),
  })
  const output = new Output({
    format: ending === 'mp4' ? new Mp4OutputFormat({ fastStart: false }) : new WebMOutputFormat(),
    target: new StreamTarget(file.writable, { chunked: true, chunkSize: CHUNK_BYTES }),
  })
  output.addVideoTrack(source, { frameRate: rate })
  output.setMetadataTags(tags)
  await output.start()
  return {
    add: (frame) => source.add(frame / rate, 1 / rate),
    async finish() {
      await output.finalize()
      return file.whole(`video/${ending}`)
    },
    drop: () => output.cancel(),
  }
}
