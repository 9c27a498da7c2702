import { phase, wholeEngine } from '../state'
import { lazily } from '../ui/lazily'

const Scrubber = lazily(async () => (await import('../playback')).fetchScrubber())

/** Keeps the slider's place free, so that nothing moves when it comes: with the whole engine, or with the first pause. */
export function ScrubberPlace() {
  const wanted =
    wholeEngine.value === 'here' || phase.value === 'paused' || phase.value === 'finished'
  return <div class="scrubber-place">{wanted && <Scrubber />}</div>
}
