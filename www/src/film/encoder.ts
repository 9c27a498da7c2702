/** What of mediabunny makes films: named here, so that in the page of one file, too, the rest of it is left out. */
export {
  CanvasSource,
  canEncodeVideo,
  Mp4OutputFormat,
  Output,
  Quality,
  StreamTarget,
  WebMOutputFormat,
} from 'mediabunny'
