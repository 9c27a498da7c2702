/** Imports results: into the draft beside its entries, or into the open comparison. */
import { Download, FileChartColumn } from 'lucide'
import { useState } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { notifyError } from '../../state'
import { download } from '../../state/export_files'
import { Button, CloseButton } from '../../ui/buttons'
import { Select } from '../../ui/fields'
import { useFilePicker } from '../../ui/file_picker'
import { FormError } from '../../ui/form_error'
import { Icon } from '../../ui/icon'
import {
  asksForMap,
  importedFiles,
  type RefusedFile,
  refusedFiles,
  removeImportedFile,
  removeRefusedFile,
  unknownMaps,
} from '../store/imported_files'
import { toldOf } from './match_words'
import { type Place, resultsTemplate, takeResultFiles, takeResults } from './take_results'

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
      <div class="imported-buttons">
        <Button
          icon={FileChartColumn}
          label={t('lab.imported.add')}
          testId="own-add"
          onClick={pick}
        />
        <Button
          icon={Download}
          label={t('lab.imported.template')}
          tone="quiet"
          testId="own-template"
          onClick={() => void saveTemplate()}
        />
      </div>
      <p class="hint">{t('lab.imported.hint')}</p>
      {element}
      {refusedFiles.value.map((file) => (
        <Refused key={file.key} file={file} maps={maps} />
      ))}
    </div>
  )
}

/** The browser saves it; a refusal is told. */
async function saveTemplate(): Promise<void> {
  try {
    download('results.csv', await resultsTemplate(), 'text/csv')
  } catch (error) {
    notifyError(error)
  }
}

/** The files that wait for the comparison to start. */
export function ImportedFiles() {
  if (importedFiles.value.length === 0) return null
  return (
    <ul class="draft-entries" aria-label={t('lab.imported.files')}>
      {importedFiles.value.map(({ key, name, match, leaveOut }) => (
        <li key={key} class="imported-file" data-testid="own-file-item">
          <Icon icon={FileChartColumn} size={16} />
          <span class="imported-words">
            <strong>{name}</strong> <span class="hint">{t('lab.imported.compared')}</span>
            {match && <span class="hint imported-match">{toldOf(match, leaveOut).join(' ')}</span>}
          </span>
          <CloseButton
            label={t('lab.imported.remove', { name })}
            onClick={() => removeImportedFile(key)}
          />
        </li>
      ))}
    </ul>
  )
}

function Refused({ file, maps }: { file: RefusedFile; maps: Place[] }) {
  if (asksForMap(file)) return <AskForMap file={file} maps={maps} />
  const unknown = unknownMaps(file)
  const leaveOut = unknown.map(({ name }) => name)
  return (
    <div class="imported-refused" data-testid="own-refused">
      <strong>{file.name}</strong>
      <Dismiss file={file} />
      <FormError error={file.error} />
      {unknown.map(({ name, runs: count }) => (
        <p key={name} class="hint">
          {t('lab.imported.onNoMap', { count, name })}
        </p>
      ))}
      {unknown.length > 0 && (
        <Button
          label={t('lab.imported.leaveOut')}
          testId="own-leave-out"
          onClick={() => void takeResults(file.name, file.bytes, { leaveOut }, file.key)}
        />
      )}
    </div>
  )
}

function AskForMap({ file, maps }: { file: RefusedFile; maps: Place[] }) {
  const [chosen, choose] = useState(maps[0]?.id ?? '')
  const instance = maps.find(({ id }) => id === chosen)
  const [named] = file.match?.matched.maps ?? []
  const question = named
    ? t('lab.imported.whichIs', { file: file.name, name: named.name })
    : t('lab.imported.onWhich', { name: file.name })
  return (
    <div class="imported-map" data-testid="own-map">
      <Select
        label={question}
        value={chosen}
        options={maps.map((map) => ({ value: map.id, label: map.name }))}
        onChange={choose}
        testId="own-map-choice"
      />
      <Button
        label={t('lab.imported.join')}
        tone="primary"
        testId="own-join"
        onClick={() => void takeResults(file.name, file.bytes, { instance }, file.key)}
      />
      <Dismiss file={file} />
    </div>
  )
}

function Dismiss({ file: { key, name } }: { file: RefusedFile }) {
  return (
    <CloseButton
      label={t('lab.imported.dismiss', { name })}
      testId="own-dismiss"
      onClick={() => removeRefusedFile(key)}
    />
  )
}
