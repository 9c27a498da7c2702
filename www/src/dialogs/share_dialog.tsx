import type { ScenarioSpec } from '@pkg/formicarium'
import { CircleQuestionMark } from 'lucide'
import { useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { addFilmWords } from '../i18n/film'
import type { Lesson } from '../model/lesson'
import type { PanelSetup, Session } from '../model/session'
import { encodeSession, PREFIX } from '../share/link'
import { caption, currentSession, latest, lesson, panels, scenario } from '../state'
import { closeDialog, show } from '../state/dialogs'
import { download, exportSession, fileStem } from '../state/export_files'
import { lazyParts } from '../state/lazy_parts'
import { askBeforeLeaving } from '../state/leaving'
import { Button } from '../ui/buttons'
import { lazily } from '../ui/lazily'
import { mapName } from '../words/map_names'
import { isSearch, labelsOf } from '../words/planner_words'
import { useNamesWords } from './names_dialog'
import { NamesFields } from './names_fields'
import type { PageContents } from './save_page'
import { isTooLong, SendDialog, useLink } from './send_dialog'

const linkCode = async () => (await Promise.all([import('./link_code'), addFilmWords()]))[0]
const LinkCode = lazily(async () => (await linkCode()).LinkCode)
const FilmButton = lazily(async () => (await linkCode()).FilmButton)
const TargetField = lazily(() => lazyParts.lesson('field'))

export function ShareDialog() {
  // Runs may go on behind the dialog, so both its words and the link are of the moment it was opened.
  const [shared] = useState(currentSession)
  const [expanded] = useState(expandedCells)
  const ready = useNamesWords()
  // What it is called, and what it sets for a lesson, may be changed here.
  const session = shared && withLesson(named(shared), lesson.value)
  const about = JSON.stringify([caption.value, session?.scenario.spec.name, lesson.value])
  const link = useLink(PREFIX, session && (() => encodeSession(session)), about)
  return (
    <SendDialog
      title={t('share.title')}
      name={caption.value.title || mapName()}
      what={t('share.what')}
      link={link}
      tooLong={(lengths) => t('share.tooLong', lengths)}
      tooLarge={t('share.tooLarge')}
      savePicture={() => savePicture(isTooLong(link) ? null : link)}
      saveFile={saveFile}
      pageOf={pageOf}
      onClose={closeDialog}
      testId="share"
    >
      {session && <Contents session={session} expanded={expanded} />}
      <AboutOffer />
      <TargetField />
      {ready && <Names />}
      {!isTooLong(link) && <LinkCode link={link} />}
      <FilmButton />
    </SendDialog>
  )
}

/** What receivers may ask. */
const AboutOffer = () => (
  <Button
    icon={CircleQuestionMark}
    label={t('share.about')}
    tone="quiet"
    testId="share-about"
    onClick={() => show('about')}
  />
)

/** With the names of now: they can be changed in the dialog. */
function named(session: Session): Session {
  const { spec } = session.scenario
  const name = scenario.value?.spec.name ?? spec.name
  return {
    ...session,
    ...caption.value,
    scenario: { ...session.scenario, spec: { ...spec, name } },
  }
}

function withLesson({ lesson: _, ...session }: Session, now: Lesson | null): Session {
  return now ? { ...session, lesson: now } : session
}

function Names() {
  const [open] = useState(() => caption.peek().title !== '' || caption.peek().note !== '')
  return (
    <details class="share-names" open={open}>
      <summary data-testid="share-names">{t('share.names')}</summary>
      <NamesFields />
    </details>
  )
}

/** What the link holds, so that nothing is shared unseen. */
function Contents({ session, expanded }: { session: Session; expanded: (number | null)[] }) {
  const labels = labelsOf(session.panels)
  const { look, inspected } = session
  return (
    <ul class="share-contents">
      <li>{mapWords(session.scenario.spec)}</li>
      {session.panels.map((panel, index) => (
        <li key={index}>
          {labels[index]} · {resultWords(panel, expanded[index] ?? null)}
        </li>
      ))}
      <li>{t('share.seed', { seed: session.seed })}</li>
      {look !== null && <li>{t('share.look', { iteration: numbers.value.whole.format(look) })}</li>}
      {inspected && (
        <li>
          {t('share.inspected', {
            x: inspected.cell[0],
            y: inspected.cell[1],
            planner: labels[inspected.panel],
          })}
        </li>
      )}
    </ul>
  )
}

/** Names that tell the size are not followed by it. */
function mapWords({ width, height, terrain }: ScenarioSpec): string {
  const name = mapName()
  const size = `${width} × ${height}`
  const words = name.includes(size) ? 'sized' : 'map'
  const what = t(`share.${words}`, { name, size })
  return terrain ? t('share.terrain', { what }) : what
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

/** A picture of the panels, with the link inside, or the session file where a link would be too long. */
async function savePicture(link: string | null): Promise<void> {
  const { racePicture } = await import('./race_picture')
  const png = await racePicture(link ?? (await exportSession()))
  download(`${fileStem()}.png`, png, 'image/png')
}

async function pageOf(): Promise<PageContents> {
  const title = caption.peek().title || mapName()
  const saved = () => askBeforeLeaving('map', false)
  return { text: await exportSession(), title, stem: fileStem(), saved }
}

async function saveFile(): Promise<void> {
  download(`${fileStem()}.experiment.json`, await exportSession(), 'application/json')
}
