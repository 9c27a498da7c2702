import { phase, rest } from '../state'
import { lazily } from '../ui/lazily'

const Scrubber = lazily(async () => (await import('../playback')).fetchScrubber())

/** Keeps the slider's place free, so that nothing moves when it comes: with the rest of the engine, or with the first pause. */
export function ScrubberPlace() {
  const wanted = rest.value === 'here' || phase.value === 'paused' || phase.value === 'finished'
  return <div class="scrubber-place">{wanted && <Scrubber />}</div>
}
