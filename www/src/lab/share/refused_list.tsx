/** Files of shares that were not taken in, each with the reasons. */
import type { JournalFault } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import { CloseButton } from '../../ui/buttons'
import {
  dismissRefusal,
  type RefusedJournal,
  refusedJournals,
  type UnlikeRun,
} from '../store/refused_journals'
import { focusCollected } from './collected_focus'
import { namesOfRun } from './run_words'

export function RefusedList() {
  return (
    <>
      {refusedJournals.value.map((refused) => (
        <Refused key={refused.key} refused={refused} />
      ))}
    </>
  )
}

function Refused({ refused: { key, name, faults, unlike, more } }: { refused: RefusedJournal }) {
  return (
    <div class="class-refused" role="alert" data-testid="class-refused">
      <p>
        <span>{t('lab.class.refusedTitle', { name })}</span>
        <CloseButton
          label={t('lab.class.dismiss', { name })}
          testId="class-dismiss"
          onClick={() => {
            dismissRefusal(key)
            focusCollected()
          }}
        />
      </p>
      <ul>
        {faults.map(({ line, fault }) => (
          <li key={line}>{t('lab.class.line', { line, why: faultWords(fault) })}</li>
        ))}
        {unlike.map((run) => (
          <li key={`${run.instance} ${run.entry} ${run.seed}`}>{unlikeWords(run, name)}</li>
        ))}
        {more > 0 && <li>{t('lab.class.more', { count: more })}</li>}
      </ul>
    </div>
  )
}

const faultWords = (fault: JournalFault) => t(`lab.class.faults.${fault.kind}`, { ...fault })

function unlikeWords(run: UnlikeRun, name: string): string {
  const names = namesOfRun(run)
  if (run.by === name) return t('lab.class.unlikeItself', names)
  if (run.by === null) return t('lab.class.unlikeHere', names)
  return t('lab.class.unlike', { ...names, other: run.by })
}
