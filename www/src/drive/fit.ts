/** What no longer fits a map that was drawn anew, cut or turned is left out, and that is said. The engine judges. */
import { effect } from '@preact/signals'
import { mapOf, wholeBox } from '../engine/tools'
import { t } from '../i18n/drive'
import { toEngineError } from '../model/errors'
import { movingOf, wallsThatFit, withMoving, without } from '../model/moving'
import type { Scenario } from '../model/session'
import { notify, notifyError, pressed, scenario } from '../state'

let started = false

/** From the first map on that has a drive. */
export function keepFitting(): void {
  if (started) return
  started = true
  effect(() => {
    const now = scenario.value
    if (now?.spec.drive && !pressed.value) void fit(now).catch(notifyError)
  })
}

/** The map with what fits takes the place of the one on show, of which undo knows as it was. */
async function fit(now: Scenario): Promise<void> {
  const fitting = await fitted(now)
  if (fitting === now || scenario.peek() !== now) return
  scenario.value = fitting
  notify('warning', t('drive.unfit'), { hint: t('drive.unfitHint') })
}

async function fitted(now: Scenario): Promise<Scenario> {
  let fitting = now
  // Each round takes out one thing, or ends.
  for (;;) {
    const why = await refused(fitting)
    if (why === null) return fitting
    const moving = movingOf(fitting)
    const changes = wallsThatFit(fitting)
    const lighter =
      why.startsWith('drive.changes') && count(changes) < count(moving.changes)
        ? { ...moving, changes }
        : without(moving, why)
    if (lighter === null) return fitting
    fitting = withMoving(fitting, lighter)
  }
}

const count = (changes: ReturnType<typeof wallsThatFit>) =>
  changes.reduce(
    (sum, { blocked, freed }) => sum + (blocked?.length ?? 0) + (freed?.length ?? 0),
    0,
  )

/** The field of the drive that the engine refuses; null where it takes all of it, or refuses the map itself. */
async function refused(map: Scenario): Promise<string | null> {
  try {
    await wholeBox().call('check', ...mapOf(map))
    return null
  } catch (thrown) {
    const { kind, field } = toEngineError(thrown)
    return kind === 'drive' ? field : null
  }
}
