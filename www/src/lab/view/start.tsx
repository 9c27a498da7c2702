/** Where a comparison begins: a new one, an earlier one, a question of a paper, a file. */
import { signal } from '@preact/signals'
import { FolderOpen } from 'lucide'
import { t } from '../../i18n/lab'
import { openFiles } from '../../state'
import { Button } from '../../ui/buttons'
import { useFilePicker } from '../../ui/file_picker'
import { FormError } from '../../ui/form_error'
import { Builder } from '../build/builder'
import { PublishedList } from '../published/published_list'
import { KeptComparisons } from './kept_comparisons'

export function Start() {
  return (
    <div class="lab-start">
      <header class="lab-welcome">
        <h2>{t('lab.start.title')}</h2>
        <p>{t('lab.start.text')}</p>
      </header>
      <Builder />
      <div class="lab-side">
        <KeptComparisons />
        <OpenFile />
        <PublishedList />
      </div>
    </div>
  )
}

/** Why a file was not opened. A signal outside the component, which is gone while a file is being opened. */
const refused = signal<unknown>(null)

function OpenFile() {
  const open = async (file: File | undefined) => {
    refused.value = null
    if (!file) return
    await openFiles([file]).catch((error: unknown) => {
      refused.value = error
    })
  }
  const { pick, element } = useFilePicker({
    label: t('lab.start.openFile'),
    accept: '.json,.png',
    testId: 'lab-file',
    onFiles: ([file]) => void open(file),
  })
  return (
    <section class="lab-card">
      {element}
      <Button
        icon={FolderOpen}
        label={t('lab.start.openFile')}
        testId="lab-open-file"
        onClick={pick}
      />
      <p class="hint">{t('lab.start.openFileHint')}</p>
      {refused.value !== null && <FormError error={refused.value} />}
    </section>
  )
}
