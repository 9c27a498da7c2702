/** Turns an entry into an ablation: the planner as it is, and without each of its components. */
import type { CatalogEntry, ComponentEntry } from '@pkg/formicarium'
import { tools } from '../../engine/tools'
import { engineText } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Entry } from '../../model/comparison'
import type { DraftEntry } from '../../model/draft'
import { notify, plannerEntry } from '../../state'
import { plannerName } from '../../words/planner_words'
import { ablated, entries as drafted, setEntries } from './draft'

/** What the id of an entry without a component begins with, and the id of the one that has all of them. */
const WITHOUT = 'without-'
const FULL = 'full'

const lacksOne = ({ id }: DraftEntry) => id?.startsWith(WITHOUT) ?? false

/** Whether it belongs to an ablation, and so cannot be ablated again. */
export const isOfAblation = (entry: DraftEntry) =>
  lacksOne(entry) || (entry.id === FULL && drafted.value.some(lacksOne))

/** Replaces all entries by those of an ablation, and offers to undo it. The engine knows which components the values leave. */
export async function ablate({ planner, preset, params }: DraftEntry): Promise<void> {
  const known = plannerEntry(planner)
  if (!known) return
  const entries = JSON.parse(await tools.ablation(planner, preset, params)) as Entry[]
  const drafts = entries.map(({ id, label, set }) => ({
    planner,
    preset,
    params: set ?? {},
    label: labelOf(id, known) ?? label,
    id,
  }))
  const [before, ofPlanner] = [drafted.peek(), ablated.peek()]
  setEntries(drafts, plannerName(known))
  if (before.length > 1)
    notify('info', t('lab.build.madeWay'), {
      action: { label: t('lab.kept.undo'), run: () => setEntries(before, ofPlanner) },
    })
}

/** In the reader's language. */
function labelOf(id: string, known: CatalogEntry): string | null {
  if (!id.startsWith(WITHOUT)) return t('lab.build.full', { planner: plannerName(known) })
  const component = known.components.find((each) => id === `${WITHOUT}${each.id}`)
  return component ? t('lab.build.without', { component: componentName(component) }) : null
}

const componentName = ({ id, name }: ComponentEntry) => engineText(`components.${id}.name`, name)
