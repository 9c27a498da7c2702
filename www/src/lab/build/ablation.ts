/** Turns an entry into an ablation: the planner as it is, and without each of its components. */
import type { AblationEntry, CatalogEntry, ComponentEntry } from '@pkg/formicarium'
import { lateTools } from '../../engine/late_tools'
import { engineText } from '../../i18n'
import { t } from '../../i18n/lab'
import type { DraftEntry } from '../../model/draft'
import { notify, plannerEntry } from '../../state'
import { plannerName } from '../../words/planner_words'
import { ablated, entries as drafted, setEntries } from './draft'

const lacksOne = ({ ablation }: DraftEntry) => ablation?.kind === 'without'

/** Whether it belongs to an ablation, and so cannot be ablated again. */
export const isOfAblation = (entry: DraftEntry) =>
  lacksOne(entry) || (entry.ablation?.kind === 'full' && drafted.value.some(lacksOne))

/** Replaces all entries by those of an ablation, and offers to undo it. The engine knows which components the values leave. */
export async function ablate({ planner, preset, params }: DraftEntry): Promise<void> {
  const known = plannerEntry(planner)
  if (!known) return
  const drafts = (await lateTools.ablation(planner, preset, params)).map(({ entry, role }) => ({
    planner,
    preset,
    params: entry.set ?? {},
    label: labelOf(role, known) ?? entry.label,
    id: entry.id,
    ablation: role,
  }))
  const [before, ofPlanner] = [drafted.peek(), ablated.peek()]
  setEntries(drafts, plannerName(known))
  if (before.length > 1)
    notify('info', t('lab.build.madeWay'), {
      action: { label: t('lab.kept.undo'), run: () => setEntries(before, ofPlanner) },
    })
}

/** In the reader's language. */
function labelOf(role: AblationEntry['role'], known: CatalogEntry): string | null {
  if (role.kind === 'full') return t('lab.build.full', { planner: plannerName(known) })
  const component = known.components.find(({ id }) => id === role.component)
  return component ? t('lab.build.without', { component: componentName(component) }) : null
}

const componentName = ({ id, name }: ComponentEntry) => engineText(`components.${id}.name`, name)
