/** The movement rules as one list of choices. */
import type { CornerRule, Movement } from '@pkg/formicarium'
import { t } from '../i18n'

export type MovementId = '4' | `8-${CornerRule}`

export const MOVEMENTS: MovementId[] = ['4', '8-both-free', '8-one-free', '8-always']

export function movementId({ moves, corner_rule }: Movement): MovementId {
  return moves === 4 ? '4' : `8-${corner_rule}`
}

export function toMovement(id: MovementId): Movement {
  if (id === '4') return { moves: 4, corner_rule: 'both-free' }
  return { moves: 8, corner_rule: id.slice(2) as CornerRule }
}

export function movementName(movement: Movement): string {
  return t(`movement.${movementId(movement)}`)
}
