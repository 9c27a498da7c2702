/** Where the drive stands, in a sentence. */
import type { EngineError } from '@pkg/formicarium'
import { t } from '../i18n/drive'
import { describeError, errorText } from '../i18n/errors'
import { drivingPanel, failure, standing } from './drive'

export function standingWords(): string {
  if (failure.value) return failureWords(failure.value)
  if (!drivingPanel.value) return t('drive.needsPanel')
  const now = standing.value
  if (!now) return t('drive.preparing')
  const { end, last } = now
  if (end?.kind === 'arrived') return t('drive.arrived', { count: last.step })
  if (end) return t('drive.stuck', { step: last.step, why: t(`drive.why.${end.why}`) })
  return last.did === 'start' ? t('drive.atStart') : t(`drive.${last.did}`, { step: last.step })
}

type Ground = 'goals' | 'slices'

/** Fields of a map on which nobody drives, whatever moves. */
const GROUNDS: ReadonlyMap<string, Ground> = new Map([
  ['goals', 'goals'],
  ['terrain.slices', 'slices'],
])

const groundOf = ({ kind, field }: EngineError) =>
  kind === 'drive' ? GROUNDS.get(field ?? '') : undefined

/** Whether it is the map that refuses a drive, not what moves on it. */
export const isUndrivable = () => failure.value !== null && groundOf(failure.value) !== undefined

/** Why something was refused. Of what moves the message says all: its hint repeats it. */
export function failureWords(error: EngineError): string {
  const ground = groundOf(error)
  if (ground) return t(`drive.grounds.${ground}`, error.args)
  return error.kind === 'drive' ? describeError(error).message : errorText(error)
}
