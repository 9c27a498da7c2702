/** Imports results: into the draft beside its entries, or into the open comparison. */
import { FileChartColumn, X } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { Button, IconButton } from '../../ui/buttons'
import { Select } from '../../ui/fields'
import { useFilePicker } from '../../ui/file_picker'
import { FormError } from '../../ui/form_error'
import { Icon } from '../../ui/icon'
import {
  asksForMap,
  importedFiles,
  type RefusedFile,
  refusedFile,
  removeImportedFile,
} from '../store/imported_files'
import { takeResultFiles, takeResults } from './take_results'

interface Place {
  id: string
  name: string
}

/** `maps`: the choices for a file that does not name its map. */
export function ImportedResults({ maps }: { maps: Place[] }) {
  const { pick, element } = useFilePicker({
    label: t('lab.imported.add'),
    accept: '.csv,.tsv,.txt,.dat,.tdat',
    multiple: true,
    testId: 'own-file',
    onFiles: (files) => void takeResultFiles(files),
  })
  return (
    <div class="imported-results">
      <Button
        icon={FileChartColumn}
        label={t('lab.imported.add')}
        testId="own-add"
        onClick={pick}
      />
      <p class="hint">{t('lab.imported.hint')}</p>
      {element}
      {refusedFile.value && (
        <Refused key={refusedFile.value.name} file={refusedFile.value} maps={maps} />
      )}
    </div>
  )
}

/** The files that wait for the comparison to start. */
export function ImportedFiles() {
  if (importedFiles.value.length === 0) return null
  return (
    <ul class="draft-entries" aria-label={t('lab.imported.files')}>
      {importedFiles.value.map(({ key, name }) => (
        <li key={key} class="imported-file" data-testid="own-file-item">
          <Icon icon={FileChartColumn} size={16} />
          <strong>{name}</strong>
          <span class="hint">{t('lab.imported.compared')}</span>
          <IconButton
            icon={X}
            label={t('lab.imported.remove', { name })}
            tone="quiet"
            size={16}
            onClick={() => removeImportedFile(key)}
          />
        </li>
      ))}
    </ul>
  )
}

function Refused({ file, maps }: { file: RefusedFile; maps: Place[] }) {
  if (asksForMap(file) && maps.length > 1) return <AskForMap file={file} maps={maps} />
  return (
    <div class="imported-refused" data-testid="own-refused">
      <strong>{file.name}</strong>
      <FormError error={file.error} />
    </div>
  )
}

function AskForMap({ file, maps }: { file: RefusedFile; maps: Place[] }) {
  const [chosen, choose] = useState(maps[0]?.id ?? '')
  return (
    <div class="imported-map" data-testid="own-map">
      <Select
        label={t('lab.imported.onWhich', { name: file.name })}
        value={chosen}
        options={maps.map((map) => ({ value: map.id, label: map.name }))}
        onChange={choose}
        testId="own-map-choice"
      />
      <Button
        label={t('lab.imported.join')}
        tone="primary"
        testId="own-join"
        onClick={() => void takeResults(file.name, file.bytes, chosen)}
      />
    </div>
  )
}
