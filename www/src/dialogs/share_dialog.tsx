import { useState } from 'preact/hooks'
import { t } from '../i18n/dialogs'
import type { Lesson } from '../model/lesson'
import type { PanelSetup, Session } from '../model/session'
import { encodeSession, PREFIX } from '../share/link'
import { currentSession, latest, lesson, panels, plannerEntry } from '../state'
import { closeDialog } from '../state/dialogs'
import { download, exportSession, fileStem } from '../state/export_files'
import { lazyParts } from '../state/lazy_parts'
import { lazily } from '../ui/lazily'
import { isSearch, plannerName } from '../words/planner_words'
import { isTooLong, SendDialog, useLink } from './send_dialog'

const TargetField = lazily(() => lazyParts.lesson('field'))

export function ShareDialog() {
  // Runs may go on behind the dialog, so both its words and the link are of the moment it was opened.
  const [opened] = useState(currentSession)
  const [expanded] = useState(expandedCells)
  // What it sets for a lesson may be changed here.
  const session = opened && withLesson(opened, lesson.value)
  const link = useLink(PREFIX, session && (() => encodeSession(session)), lesson.value)
  return (
    <SendDialog
      title={t('share.title')}
      what={t('share.what')}
      link={link}
      tooLong={(lengths) => t('share.tooLong', lengths)}
      tooLarge={t('share.tooLarge')}
      savePicture={() => savePicture(isTooLong(link) ? null : link)}
      saveFile={saveFile}
      onClose={closeDialog}
      testId="share"
    >
      {session && <Contents session={session} expanded={expanded} />}
      <TargetField />
    </SendDialog>
  )
}

function withLesson({ lesson: _, ...session }: Session, now: Lesson | null): Session {
  return now ? { ...session, lesson: now } : session
}

/** What the link holds, so that nothing is shared unseen. */
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

/** Colonies count iterations, searches expanded cells; the latter are known only for the run on show. */
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

/** A picture of the panels, with the link inside, or the session file where a link would be too long. */
async function savePicture(link: string | null): Promise<void> {
  const { racePicture } = await import('./race_picture')
  const png = await racePicture(link ?? (await exportSession()))
  download(`${fileStem()}.png`, png, 'image/png')
}

async function saveFile(): Promise<void> {
  download(`${fileStem()}.experiment.json`, await exportSession(), 'application/json')
}
