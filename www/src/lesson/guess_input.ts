/** Guessing on the map: a cell beside the ant, or the number that stands on it. */
import { t } from '../i18n/lesson'
import type { Cell } from '../model/cell'
import { sameCell } from '../model/edit'
import { announce } from '../state'
import { guess, nextQuestion, optionsOf, question } from './guess'
import type { MapHandlers } from './map_input'
import { revealed } from './questions'

export const guessHandlers: MapHandlers = {
  press: choose,
  enter: choose,
  key: ({ key }) => chooseByNumber(key),
}

/** While an answer is on show, the next press goes on. */
function choose(cell: Cell): void {
  if (revealed.peek()) {
    nextQuestion()
    return
  }
  const turn = question.peek()
  const option = turn && optionsOf(turn).find(({ to }) => sameCell(to, cell))
  if (option) guess(option)
  else if (turn) announce(t('lesson.guess.notOption', { x: cell[0], y: cell[1] }))
}

export function chooseByNumber(key: string): boolean {
  const turn = question.peek()
  const option = turn && !revealed.peek() ? optionsOf(turn)[Number(key) - 1] : undefined
  if (!/^[1-9]$/.test(key) || !option) return false
  guess(option)
  return true
}
