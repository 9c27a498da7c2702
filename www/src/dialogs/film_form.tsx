/** Chooses what is made of the race, shows how it begins and ends, makes it, and hands it over. */
import '../styles/film.css'
import { useSignal } from '@preact/signals'
import { Clapperboard, Download, X } from 'lucide'
import { useEffect, useRef, useState } from 'preact/hooks'
import { linkOfRace } from '../film/link_of_race'
import { t } from '../i18n/film'
import { MOST_BYTES } from '../model/memory'
import { panels } from '../state'
import { closeDialog } from '../state/dialogs'
import { download } from '../state/export_files'
import { memoryNeeded } from '../state/memory'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { Segmented } from '../ui/fields'
import { FormError } from '../ui/form_error'
import { firstDraft, type What } from './film_draft'
import { FilmFields } from './film_fields'
import { FilmPreview } from './film_preview'
import { FilmStatus } from './film_status'
import { make, useEncoding, usePreview, type Work } from './film_work'

const WHATS: What[] = ['film', 'steps', 'slides']

export function FilmForm() {
  const [draft, setDraft] = useState(firstDraft)
  // Runs may go on behind the dialog: the link is of the moment it was opened.
  const [link] = useState(linkOfRace)
  const [first, setFirst] = useState(true)
  const work = useSignal<Work>({ phase: 'choosing' })
  const { phase } = work.value
  const tooLarge = 2 * memoryNeeded.value > MOST_BYTES
  const encoding = useEncoding(draft)
  const preview = usePreview(draft, link, first, phase === 'choosing' && !tooLarge)
  const { start, stop } = useMaking(work)
  const lacks = panels.value.length === 0 || tooLarge || (draft.what === 'film' && !encoding)
  const begin = () =>
    start((signal) => make(draft, link, encoding ?? null, work, preview.canvas.current, signal))
  return (
    <Dialog
      title={t('film.title')}
      onClose={closeDialog}
      testId="film-dialog"
      wide
      actions={<Actions {...{ work: work.value, what: draft.what, lacks, begin, stop }} />}
    >
      <fieldset class="film-choices" disabled={phase !== 'choosing'}>
        <Segmented
          label={t('film.what')}
          value={draft.what}
          options={WHATS.map((value) => ({
            value,
            label: t(`film.whats.${value}`),
            testId: `film-${value}`,
          }))}
          onChange={(what) => setDraft({ ...draft, what })}
        />
        <p class="hint film-note">{t(`film.notes.${draft.what}`)}</p>
        <FilmFields draft={draft} onChange={setDraft} />
      </fieldset>
      <FilmPreview
        work={work.value}
        size={draft}
        first={first}
        canvas={preview.canvas}
        isReady={preview.isReady}
        onFirst={setFirst}
      >
        <FilmStatus work={work.value} draft={draft} encoding={encoding} tooLarge={tooLarge} />
      </FilmPreview>
      {work.value.phase === 'choosing' && work.value.error !== undefined && (
        <FormError error={work.value.error} />
      )}
    </Dialog>
  )
}

/** At most one thing is being made; it ends with the dialog. */
function useMaking(work: { value: Work }) {
  const under = useRef<AbortController | null>(null)
  const stop = () => {
    under.current?.abort()
    under.current = null
    work.value = { phase: 'choosing' }
  }
  useEffect(() => () => under.current?.abort(), [])
  const start = (making: (signal: AbortSignal) => Promise<void>) => {
    under.current = new AbortController()
    void making(under.current.signal)
  }
  return { start, stop }
}

const MAKE = { film: 'film.make', steps: 'film.makeSteps', slides: 'film.makeSlides' } as const

interface ActionsProps {
  work: Work
  what: What
  /** Something that it takes is not there. */
  lacks: boolean
  begin: () => void
  /** Gives up what is being made, or leaves what has been made. */
  stop: () => void
}

function Actions({ work, what, lacks, begin, stop }: ActionsProps) {
  if (work.phase === 'making')
    return <Button icon={X} label={t('film.cancel')} testId="film-stop" onClick={stop} />
  if (work.phase === 'choosing')
    return (
      <Button
        icon={Clapperboard}
        label={t(MAKE[what])}
        tone="primary"
        testId="film-make"
        disabled={lacks}
        onClick={begin}
      />
    )
  const { name, made } = work
  return (
    <>
      <Button label={t('film.again')} tone="quiet" testId="film-again" onClick={stop} />
      <Button
        icon={Download}
        label={t('film.save', { name })}
        tone="primary"
        testId="film-save"
        onClick={() => download(name, made.file, made.file.type)}
      />
    </>
  )
}
