/** How much room there is. On a compact screen the column beside the maps is a sheet above them. */
import { effect, signal } from '@preact/signals'

/** A phone, a tablet held upright, or a window zoomed so far. The styles ask for `data-compact`, so this is the only place that knows. */
const query = matchMedia('(width < 1000px), (height < 500px)')

export const compact = signal(query.matches)
query.addEventListener('change', ({ matches }) => {
  compact.value = matches
})

effect(() => {
  document.documentElement.dataset.compact = String(compact.value)
})
