import type { RunSummary } from '@pkg/formicarium'
import { BadgeCheck, TriangleAlert } from 'lucide'
import { t } from '../i18n'
import { type Panel, type Phase, phase, plannerEntry, type Verification } from '../state'
import { Icon } from '../ui/icon'

type StatusWord =
  | 'refused'
  | 'ready'
  | 'exploring'
  | 'searching'
  | 'paused'
  | 'optimal'
  | 'stagnated'
  | 'budget-spent'
  | 'no-path'

/** What the panel's run is doing, in one word. */
export function StatusChip({ panel, place }: { panel: Panel; place: number }) {
  const { summary, verified, error } = panel.live.value
  const exact = plannerEntry(panel.setup.planner)?.family === 'exact'
  const word = error ? 'refused' : statusWord(summary, phase.value, exact)
  return (
    <>
      <span class={`chip status-${word}`} data-testid={`status-${place}`} data-status={word}>
        {t(`status.${word}`)}
      </span>
      <VerifiedChip panel={panel} verified={verified} exact={exact} place={place} />
    </>
  )
}

function statusWord(summary: RunSummary | null, now: Phase, exact: boolean): StatusWord {
  if (summary && summary.status !== 'running') return summary.status
  if (now === 'running') return exact ? 'searching' : 'exploring'
  return now === 'editing' ? 'ready' : 'paused'
}

interface VerifiedChipProps {
  panel: Panel
  verified: Verification
  exact: boolean
  place: number
}

/** Says what was verified: the run on show has only begun, the recorded one was repeated as far as it went. */
function VerifiedChip({ panel, verified, exact, place }: VerifiedChipProps) {
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
      {exact && verified !== 'pending'
        ? t(`verified.${verified}Exact`)
        : t(`verified.${verified}`, { count })}
    </span>
  )
}
