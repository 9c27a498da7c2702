/** The movement rules as one list of choices. */
import type { CornerRule, Movement, ScenarioSpec } from '@pkg/formicarium'
import { t } from '../i18n'

export type MovementId = '4' | `8-${CornerRule}` | `16-${CornerRule}`

export const MOVEMENTS: MovementId[] = [
  '4',
  '8-both-free',
  '8-one-free',
  '8-always',
  '16-both-free',
  '16-one-free',
  '16-always',
]

export function movementId({ moves, corner_rule }: Movement): MovementId {
  return moves === 4 ? '4' : `${moves}-${corner_rule}`
}

export function toMovement(id: MovementId): Movement {
  if (id === '4') return { moves: 4, corner_rule: 'both-free' }
  const moves = id.startsWith('16') ? 16 : 8
  return { moves, corner_rule: id.slice(id.indexOf('-') + 1) as CornerRule }
}

export function movementName(movement: Movement): string {
  return t(`movement.${movementId(movement)}`)
}

/** How one moves in a scenario, in a few words. */
export function waysOfMoving({ movement, terrain }: ScenarioSpec): string {
  return terrain?.slices ? t('terrain.bySlices') : movementName(movement)
}
