/** The shares that a class has brought: which are in, which are missing, and the files that were not taken in. */
import { Copy, FolderOpen } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { importFiles, notifyError } from '../../state'
import { Button } from '../../ui/buttons'
import { copyText } from '../../ui/copy_text'
import { useFilePicker } from '../../ui/file_picker'
import { type OpenComparison, openComparison, progress } from '../run/actions'
import { runsOfQuestion, type ShareState, sharesOfRuns, statesOfShares } from '../run/shares'
import { forgetRefusals, refusedJournals } from '../store/refused_journals'
import { linkOfQuestion, linkOfShare } from './class_links'
import { COLLECTED_TITLE } from './collected_focus'
import { RefusedList } from './refused_list'
import { Sample } from './sample'
import { ShareTable } from './share_table'

export function CollectedCard() {
  const now = openComparison.value
  useEffect(() => forgetRefusals, [now?.id])
  if (!now) return null
  const isClass = now.dealt !== null || now.brought.length > 0
  if (!isClass && refusedJournals.value.length === 0) return null
  return (
    <section class="lab-card class-card" aria-labelledby={COLLECTED_TITLE} data-testid="class-card">
      <h3 id={COLLECTED_TITLE} tabIndex={-1}>
        {t('lab.class.collected')}
      </h3>
      <RefusedList />
      {isClass && <Collected now={now} />}
      {now.brought.some(({ runs }) => runs > 0) && <Sample />}
    </section>
  )
}

/** Shares are those that were dealt here, or else those of the first file that is one. */
function sharesOf({ dealt, brought }: OpenComparison): number | null {
  const [, of] = brought.find(({ share }) => share !== null)?.share?.split('/') ?? []
  return dealt ?? (of === undefined ? null : Number(of))
}

function Collected({ now }: { now: OpenComparison }) {
  const of = sharesOf(now)
  const states = useStates(now.id, of)
  const missing = states.filter(({ done, runs }) => done < runs)
  const { all, there } = runsOfQuestion()
  const { whole } = numbers.value
  const sums = [
    ...(of === null
      ? []
      : [t('lab.class.sum', { in: states.length - missing.length, of: whole.format(of) })]),
    t('lab.class.sumRuns', { done: whole.format(there), runs: whole.format(all) }),
  ]
  return (
    <>
      <p role="status" data-testid="class-sum">
        {sums.join(' · ')}
      </p>
      <div class="class-row">
        <AddShares />
        {of !== null && missing.length > 0 && <CopyMissing of={of} missing={missing} />}
        <p class="hint">{t('lab.class.addHint')}</p>
      </div>
      <ShareTable of={of} states={states} brought={now.brought} />
    </>
  )
}

/** How far each share is; empty until it is known which runs are whose. */
function useStates(id: string, of: number | null): ShareState[] {
  const [known, setKnown] = useState<{ of: number; id: string; shares: Uint32Array } | null>(null)
  useEffect(() => {
    let wanted = true
    if (of === null) return
    sharesOfRuns(of).then((shares) => wanted && setKnown({ of, id, shares }), notifyError)
    return () => {
      wanted = false
    }
  }, [id, of])
  // They change with every run that is done or taken in.
  progress.value
  return of !== null && known?.of === of && known.id === id ? statesOfShares(of, known.shares) : []
}

function AddShares() {
  const { pick, element } = useFilePicker({
    label: t('lab.class.add'),
    accept: '.journal,.png',
    multiple: true,
    testId: 'class-files',
    onFiles: (files) => void importFiles(files),
  })
  return (
    <>
      {element}
      <Button icon={FolderOpen} label={t('lab.class.add')} testId="class-add" onClick={pick} />
    </>
  )
}

function CopyMissing({ of, missing }: { of: number; missing: ShareState[] }) {
  const copy = async () => {
    const link = await linkOfQuestion()
    await copyText(missing.map(({ share }) => linkOfShare(link, share, of)).join('\n'))
  }
  return (
    <Button
      icon={Copy}
      label={t('lab.class.copyMissing', { count: missing.length })}
      tone="quiet"
      testId="class-copy-missing"
      onClick={() => void copy().catch(notifyError)}
    />
  )
}
