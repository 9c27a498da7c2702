import type { RunSummary } from '@pkg/formicarium'
import { BadgeCheck, TriangleAlert } from 'lucide'
import { t } from '../i18n'
import type { Verification } from '../model/scripting'
import { type Panel, type Phase, phase, shownOf } from '../state'
import { Icon } from '../ui/icon'
import { OTHER_VALUES, objectiveWord } from '../words/objective_words'
import { isSearch } from '../words/planner_words'

type StatusWord =
  | 'refused'
  | 'ready'
  | 'exploring'
  | 'searching'
  | 'paused'
  | 'optimal'
  | 'complete'
  | 'stagnated'
  | 'budget-spent'
  | 'no-path'

/** What the panel's run is doing, in one word. */
export function StatusChip({ panel, place }: { panel: Panel; place: number }) {
  const { summary, verified, error } = shownOf(panel)
  const search = isSearch(panel.setup.planner)
  const word = error ? 'refused' : statusWord(summary, phase.value, search)
  const words = word === 'optimal' && isNoLength(summary) ? 'optimal-value' : word
  return (
    <>
      <span class={`chip status-${word}`} data-testid={`status-${place}`} data-status={word}>
        {t(`status.${words}`)}
      </span>
      <VerifiedChip panel={panel} verified={verified} search={search} place={place} />
    </>
  )
}

function statusWord(summary: RunSummary | null, now: Phase, search: boolean): StatusWord {
  if (summary && summary.status !== 'running') return summary.status
  if (now === 'running') return search ? 'searching' : 'exploring'
  return now === 'editing' ? 'ready' : 'paused'
}

/** What is proven least is not always a length. */
function isNoLength(summary: RunSummary | null): boolean {
  return summary !== null && objectiveWord(summary.objective) in OTHER_VALUES
}

interface VerifiedChipProps {
  panel: Panel
  verified: Verification
  search: boolean
  place: number
}

/** Says what was verified: the run on show has only begun, the recorded one was repeated as far as it went. */
function VerifiedChip({ panel, verified, search, place }: VerifiedChipProps) {
  if (verified === 'none') return null
  const count = panel.setup.result?.iterations ?? 0
  const icon = { pending: null, verified: BadgeCheck, differs: TriangleAlert }[verified]
  return (
    <span
      class={`chip verified-${verified}`}
      data-testid={`verified-${place}`}
      data-verified={verified}
      title={t(`verified.${verified}Hint`)}
    >
      {icon && <Icon icon={icon} size={14} />}
      {search && verified !== 'pending'
        ? t(`verified.${verified}Exact`)
        : t(`verified.${verified}`, { count })}
    </span>
  )
}
