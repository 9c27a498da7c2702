/** How much room there is. On a compact screen the column beside the maps is a sheet above them. */
import { effect, type Signal, signal } from '@preact/signals'

/** A phone, a tablet held upright, or a window zoomed so far. The styles ask for `data-compact`, so this is the only place that knows. */
const query = matchMedia('(width < 1000px), (height < 500px)')

export const compact = followed(query)

/** A phone held upright: its bar has room for the buttons that run a race, and the sheet has the rest. */
export const narrow = followed(matchMedia('(width < 520px) and (height >= 500px)'))

function followed(media: MediaQueryList): Signal<boolean> {
  const matches = signal(media.matches)
  media.addEventListener('change', (change) => {
    matches.value = change.matches
  })
  return matches
}

effect(() => {
  document.documentElement.dataset.compact = String(compact.value)
})
