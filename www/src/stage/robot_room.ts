/** Offers a way out when the robot does not fit where a path begins or ends, which is said above the maps. Started with the legend. */
import { effect } from '@preact/signals'
import { lateTools } from '../engine/late_tools'
import { t } from '../i18n/weights'
import { endsWithRoom } from '../model/robot_room'
import { announce, commit, dismiss, notify, notifyError, scenario, scenarioNotices } from '../state'
import { mapIsFixed } from '../state/embedding'

const NARROW = /^(start|goal)-too-narrow$/

let told = ''
let offered: number | null = null

export function offerRoom(): void {
  effect(() => {
    const notice = scenarioNotices.value.find(({ kind }) => NARROW.test(kind))
    const key = notice ? JSON.stringify(notice) : ''
    if (key === told) return
    told = key
    if (offered !== null) dismiss(offered)
    offered = null
    if (!notice || mapIsFixed.peek()) return
    const action = { label: t('weights.move'), run: () => void moveEnds().catch(notifyError) }
    offered = notify('warning', t('weights.needsRoom'), { hint: t('weights.orSmaller'), action })
  })
}

async function moveEnds(): Promise<void> {
  const now = scenario.peek()
  const ends = now && endsWithRoom(now.spec, await lateTools.feltMap(now))
  if (!now || scenario.peek() !== now) return
  if (ends) commit({ ...now, spec: { ...now.spec, ...ends } })
  announce(t(ends ? 'weights.moved' : 'weights.nowhere'))
}
