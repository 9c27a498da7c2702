/** Files may be dropped anywhere on the page. */
import { signal } from '@preact/signals'
import { Upload } from 'lucide'
import { t } from '../i18n'
import { importDropped } from '../state'
import { Icon } from '../ui/icon'

const over = signal(false)

/** Shown while files are held over the page. */
export function DropVeil() {
  if (!over.value) return null
  return (
    <div class="drop-veil" aria-hidden="true">
      <Icon icon={Upload} size={40} />
      <p>{t('maps.dropHere')}</p>
    </div>
  )
}

export function listenForDrops(): void {
  addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return
    event.preventDefault()
    over.value = true
  })
  addEventListener('dragleave', (event) => {
    // Only when the pointer leaves the window, not when it moves between elements.
    if (event.relatedTarget === null) over.value = false
  })
  addEventListener('drop', (event) => {
    over.value = false
    if (!carriesFiles(event) || !event.dataTransfer) return
    event.preventDefault()
    void importDropped(event.dataTransfer)
  })
}

const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
