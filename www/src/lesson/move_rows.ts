/** An ant's moves as the table and the arrows of the inspector take them. */
import type { AntTurn } from '@pkg/formicarium'
import type { Move } from '../playback'

export const movesOfTurn = ({ moves }: AntTurn): Move[] =>
  moves.map(({ to: [x, y], ...move }) => ({ colony: 0, x, y, ...move }))
