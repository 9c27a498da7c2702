import { compact, narrow, phase, wholeEngine } from '../state'
import { lazily } from '../ui/lazily'
import { SeedField } from './run_settings'
import { SpeedField } from './speed_field'
import { Transport } from './transport'

const Scrubber = lazily(async () => (await import('../playback')).fetchScrubber())

/** Running, looking back and how fast, in one row below the maps. */
export function PlayBar() {
  return (
    <div class="play-bar">
      <Transport />
      {!narrow.value && <SpeedField />}
      <ScrubberPlace />
      {!compact.value && <SeedField />}
    </div>
  )
}

/** Keeps the slider's place free, so that nothing moves when it comes: with the whole engine, or with the first pause. */
export function ScrubberPlace() {
  const wanted =
    wholeEngine.value === 'here' || phase.value === 'paused' || phase.value === 'finished'
  return <div class="scrubber-place">{wanted && <Scrubber />}</div>
}
