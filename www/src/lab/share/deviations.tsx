/** Differences in plain words, causes first, as the engine lists them. */
import type { Deviation } from '@pkg/formicarium'
import { t } from '../../i18n/lab'
import { paramName } from '../../words/planner_words'
import { shownComparison } from '../store/shown_comparison'

/** One cause may make hundreds of entries differ: a few of each kind are shown. */
const SHOWN_OF_KIND = 8

type Kind = Deviation['kind']

export function Deviations({ all }: { all: Deviation[] }) {
  const kinds = [...new Set(all.map(({ kind }) => kind))]
  return (
    <ul class="deviations" data-testid="deviations">
      {kinds.map((kind) => (
        <OfKind key={kind} kind={kind} all={all.filter((one) => one.kind === kind)} />
      ))}
    </ul>
  )
}

function OfKind({ kind, all }: { kind: Kind; all: Deviation[] }) {
  const more = all.length - SHOWN_OF_KIND
  return (
    <>
      {all.slice(0, SHOWN_OF_KIND).map((one, at) => (
        <li key={at} data-kind={kind}>
          {wordsOf(one)}
          {'recorded' in one && (kind === 'bits' || kind === 'comparison') && (
            <span class="hint">
              {t('lab.verify.digests', { recorded: one.recorded, now: one.now })}
            </span>
          )}
        </li>
      ))}
      {more > 0 && <li data-kind={kind}>{t('lab.verify.more', { count: more })}</li>}
    </>
  )
}

function wordsOf(one: Deviation): string {
  switch (one.kind) {
    case 'version':
      return t('lab.verify.version', { recorded: one.recorded, now: one.now })
    case 'comparison':
      return t('lab.verify.comparison')
    case 'parameter':
      return parameterWords(one)
    case 'edited':
      return t('lab.verify.edited', namesOf(one))
    case 'bits':
      return bitsWords(one)
  }
}

function parameterWords(one: Deviation & { kind: 'parameter' }): string {
  const { entry, key, recorded, now } = one
  const values = { recorded: String(recorded), now: String(now) }
  const words = { entry: labelOf(entry), key: paramName({ key }), ...values }
  if (recorded === null) return t('lab.verify.parameterNew', words)
  return t(now === null ? 'lab.verify.parameterGone' : 'lab.verify.parameter', words)
}

function bitsWords(one: Deviation & { kind: 'bits' }): string {
  const { seed, differing } = one
  const words = { ...namesOf(one), seed, differing }
  if (seed == null) return t('lab.verify.bitsAll', words)
  return t(differing === 1 ? 'lab.verify.bitsOne' : 'lab.verify.bits', words)
}

function namesOf({ entry, instance }: { entry: string; instance: string }) {
  const now = shownComparison.peek()
  const at = now?.question.instances.findIndex(({ id }) => id === instance) ?? -1
  return { entry: labelOf(entry), map: now?.maps[at]?.name || instance }
}

const labelOf = (entry: string) =>
  shownComparison.peek()?.question.entries.find(({ id }) => id === entry)?.label ?? entry
