/** A session that brings things that move is offered as a drive, and what no longer fits its map is left out. */
import { effect } from '@preact/signals'
import { t } from '../i18n/drive'
import { isStill, movingOf } from '../model/moving'
import { lessonMode, notify, notifyError, scenario } from '../state'

let started = false

/** Started once. */
export function offerDrives(): void {
  if (started) return
  started = true
  let moved = false
  effect(() => {
    const now = scenario.value
    const moves = now !== null && !isStill(movingOf(now))
    const isNew = moves && !moved
    moved = moves
    if (isNew) void offer().catch(notifyError)
  })
}

async function offer(): Promise<void> {
  const { keepFitting } = await (await import('../drive')).fetchFitting()
  keepFitting()
  if (lessonMode.peek() === 'drive') return
  const run = () => {
    lessonMode.value = 'drive'
  }
  notify('info', t('drive.offer'), {
    hint: t('drive.offerHint'),
    action: { label: t('drive.offered'), run },
  })
}
