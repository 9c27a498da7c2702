/** The results as files: the same bytes as the command line writes. */
import { Copy, Download } from 'lucide'
import { language } from '../../i18n'
import { t } from '../../i18n/lab'
import type { ResultFile } from '../../model/analysis'
import { announce, notify, notifyError } from '../../state'
import { download } from '../../state/export_files'
import { Button } from '../../ui/buttons'
import { openComparison, resultFile, timesFile } from '../run/actions'
import { frontsAsked } from '../store/fronts_asked'
import { metresOfMaps } from '../store/metres'
import { fileStem } from '../store/names'

interface FileKind {
  kind: Exclude<ResultFile, 'link'> | 'times'
  ending: string
  type: string
  /** Text that goes into a document is copied rather than kept. */
  copied?: true
}

const FILES: FileKind[] = [
  { kind: 'csv', ending: 'csv', type: 'text/csv' },
  { kind: 'json', ending: 'json', type: 'application/json' },
  { kind: 'matrix-csv', ending: 'matrix.csv', type: 'text/csv' },
  { kind: 'matrix-markdown', ending: 'matrix.md', type: 'text/markdown', copied: true },
  { kind: 'matrix-latex', ending: 'matrix.tex', type: 'application/x-tex', copied: true },
  { kind: 'summary-csv', ending: 'summary.csv', type: 'text/csv' },
  { kind: 'summary-json', ending: 'summary.json', type: 'application/json' },
  { kind: 'summary-markdown', ending: 'summary.md', type: 'text/markdown', copied: true },
  { kind: 'markdown', ending: 'md', type: 'text/markdown', copied: true },
  { kind: 'latex', ending: 'tex', type: 'application/x-tex', copied: true },
  { kind: 'fronts-csv', ending: 'fronts.csv', type: 'text/csv' },
  { kind: 'fronts-markdown', ending: 'fronts.md', type: 'text/markdown', copied: true },
  { kind: 'fronts-latex', ending: 'fronts.tex', type: 'application/x-tex', copied: true },
  { kind: 'tests', ending: 'tests.md', type: 'text/markdown', copied: true },
  { kind: 'tests-csv', ending: 'tests.csv', type: 'text/csv' },
  { kind: 'claims-csv', ending: 'claims.csv', type: 'text/csv' },
  { kind: 'times', ending: 'times.csv', type: 'text/csv' },
]

export function FilesTab() {
  return (
    <>
      <p class="hint">{t('lab.results.filesHint')}</p>
      {metresOfMaps.value && <p class="hint">{t('lab.results.unit.files')}</p>}
      <ul class="result-files">
        {FILES.map((file) => (
          <FileRow key={file.kind} file={file} />
        ))}
      </ul>
    </>
  )
}

function FileRow({ file }: { file: FileKind }) {
  const { kind, ending, type } = file
  const name = `${fileStem(openComparison.value?.title ?? '')}.${ending}`
  const save = () =>
    contents(kind)
      .then((text) => download(name, text, type))
      .catch(notifyError)
  return (
    <li data-testid={`file-row-${kind}`}>
      <div class="file-words">
        <strong>{nameOf(kind)}</strong>
        <span class="hint">{aboutOf(kind)}</span>
        <code>{name}</code>
      </div>
      {file.copied && (
        <Button
          icon={Copy}
          label={t('common.copy')}
          tone="quiet"
          testId={`copy-${kind}`}
          onClick={() => copy(kind)}
        />
      )}
      <Button
        icon={Download}
        label={t('lab.results.download')}
        testId={`file-${kind}`}
        onClick={save}
      />
    </li>
  )
}

type OfMatrix = Extract<FileKind['kind'], `matrix-${string}`>
type OfFronts = Extract<FileKind['kind'], `fronts-${string}`>

const isOfMatrix = (kind: FileKind['kind']): kind is OfMatrix => kind.startsWith('matrix-')
const isOfFronts = (kind: FileKind['kind']): kind is OfFronts => kind.startsWith('fronts-')

function nameOf(kind: FileKind['kind']): string {
  if (isOfMatrix(kind)) return t(`lab.matrix.files.${kind}`)
  return isOfFronts(kind) ? t(`lab.fronts.files.${kind}`) : t(`lab.results.files.${kind}`)
}

function aboutOf(kind: FileKind['kind']): string {
  if (isOfMatrix(kind)) return t(`lab.matrix.filesAbout.${kind}`)
  return isOfFronts(kind) ? t(`lab.fronts.filesAbout.${kind}`) : t(`lab.results.filesAbout.${kind}`)
}

/** What people read is in the page's language; fronts are those that are shown. */
async function contents(kind: FileKind['kind']): Promise<string> {
  if (kind === 'times') return timesFile()
  const fronts = isOfFronts(kind) ? frontsAsked.peek() : null
  return resultFile(kind, { language: language.peek(), ...(fronts && { fronts }) })
}

async function copy(kind: FileKind['kind']): Promise<void> {
  try {
    await navigator.clipboard.writeText(await contents(kind))
    announce(t('common.copied'))
    notify('success', t('common.copied'))
  } catch {
    notify('warning', t('common.copyFailed'), { hint: t('lab.results.copyFailedHint') })
  }
}
