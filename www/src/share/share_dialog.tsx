import { Copy, FileDown, ImageDown } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { isSearch, plannerName } from '../panels/planner_text'
import type { PanelSetup, Session } from '../session'
import {
  currentSession,
  download,
  exportExperiment,
  fileStem,
  latest,
  notifyError,
  panels,
  plannerEntry,
} from '../state'
import { Button } from '../ui/buttons'
import { copyText } from '../ui/copy'
import { Dialog } from '../ui/dialog'
import { closeDialog } from '../ui/dialogs'
import { encodeSession, LINK_LIMIT, LinkError } from './link'

/** In the place of a link that cannot be. */
const TOO_LARGE = 'too large'

export function ShareDialog() {
  // Runs may go on behind the dialog: what it says and what the link carries are of one moment.
  const [session] = useState(currentSession)
  const [expanded] = useState(expandedCells)
  const link = useLink(session)
  const tooLong = link === TOO_LARGE || (link !== null && link.length > LINK_LIMIT)
  return (
    <Dialog
      title={t('share.title')}
      onClose={closeDialog}
      testId="share-dialog"
      actions={
        <>
          <Button
            icon={ImageDown}
            label={t('share.picture')}
            testId="share-picture"
            disabled={link === null}
            onClick={() => savePicture(tooLong ? null : link).catch(notifyError)}
          />
          <Button
            icon={FileDown}
            label={t('share.file')}
            tone={tooLong ? 'primary' : 'plain'}
            testId="share-file"
            onClick={saveFile}
          />
          {!tooLong && (
            <Button
              icon={Copy}
              label={t('share.copy')}
              tone="primary"
              testId="share-copy"
              disabled={link === null}
              onClick={() => copyText(link ?? '')}
            />
          )}
        </>
      }
    >
      <p>{t('share.what')}</p>
      {session && <Contents session={session} expanded={expanded} />}
      {tooLong ? (
        <p class="banner" data-testid="share-too-long">
          {link === TOO_LARGE
            ? t('share.tooLarge')
            : t('share.tooLong', {
                length: numbers.value.whole.format(link?.length ?? 0),
                limit: numbers.value.whole.format(LINK_LIMIT),
              })}
        </p>
      ) : (
        <>
          <input
            class="input share-link"
            readOnly
            value={link ?? t('common.working')}
            aria-label={t('share.link')}
            data-testid="share-link"
            onFocus={(event) => event.currentTarget.select()}
          />
          <p class="hint">{t('share.private', { length: link?.length ?? 0 })}</p>
        </>
      )}
    </Dialog>
  )
}

/** What the link will bring back, so that nothing is shared unseen. */
function Contents({ session, expanded }: { session: Session; expanded: (number | null)[] }) {
  const { spec } = session.scenario
  return (
    <ul class="share-contents">
      <li>
        {t(spec.terrain ? 'share.terrain' : 'share.map', {
          name: spec.name,
          width: spec.width,
          height: spec.height,
        })}
      </li>
      {session.panels.map((panel, index) => (
        <li key={index}>
          {panelName(panel.planner)} · {resultWords(panel, expanded[index] ?? null)}
        </li>
      ))}
      <li>{t('share.seed', { seed: session.seed })}</li>
    </ul>
  )
}

/** Colonies count iterations, searches the cells they have looked at: known when the run on show is the recorded one. */
function resultWords({ planner, result }: PanelSetup, expanded: number | null): string {
  if (!result) return t('share.noResult')
  const { iterations, digest } = result
  if (!isSearch(planner)) return t('share.result', { iterations, digest })
  if (expanded === null) return t('share.resultRecorded', { digest })
  return t('share.resultExact', { count: expanded, digest })
}

function expandedCells(): (number | null)[] {
  return panels.peek().map(({ id }) => {
    const { summary } = latest(id)
    return summary && summary.iteration > 0 ? summary.effort.cell_expansions : null
  })
}

function panelName(id: string): string {
  const entry = plannerEntry(id)
  return entry ? plannerName(entry) : id
}

/** The whole address, or that it is too large; null while it is being made. */
function useLink(session: Session | null): string | null {
  const [link, setLink] = useState<string | null>(null)
  useEffect(() => {
    if (!session) return
    const page = location.href.replace(/#.*$/, '')
    encodeSession(session).then(
      (text) => setLink(`${page}#x=${text}`),
      (error) => {
        if (error instanceof LinkError) setLink(TOO_LARGE)
        else notifyError(error)
      },
    )
  }, [session])
  return link
}

/** The panels as they stand; inside the link, or what the file has where that is too long. */
async function savePicture(link: string | null): Promise<void> {
  const { racePicture } = await import('./picture')
  const png = await racePicture(link ?? (await exportExperiment()))
  download(`${fileStem()}.png`, png, 'image/png')
}

async function saveFile(): Promise<void> {
  download(`${fileStem()}.experiment.json`, await exportExperiment(), 'application/json')
}
