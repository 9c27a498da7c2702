/** Guessing the next moves of an ant, one by one along its walk. */
import type { AntMove, AntTurn } from '@pkg/formicarium'
import { batch, computed, effect } from '@preact/signals'
import { latest, lesson, lessonMode, lookedAt, panelById, panels } from '../state'
import { changeLesson } from './change_lesson'
import { follow, followed, seen, stopFollowing } from './follow'
import { answers, guessMoves, revealed } from './questions'
import type { Answer } from './score'

/** On the walk that begins where the run stands, or at the iteration that is looked at. */
export function startGuessing(panelId: number, ant: number): void {
  const panel = panels.peek().findIndex(({ id }) => id === panelId)
  const reached = latest(panelId).summary?.iteration ?? 0
  begin({ panel, ant, iteration: Math.min(reached, lookedAt.peek() ?? reached) })
}

export function guessAgain(): void {
  const questions = lesson.peek()?.questions
  if (questions) begin(questions)
}

export function guessNextAnt(): void {
  const questions = lesson.peek()?.questions
  if (questions) begin({ ...questions, ant: questions.ant + 1 })
}

function begin(questions: { panel: number; ant: number; iteration: number }): void {
  const panelId = panels.peek()[questions.panel]?.id
  if (panelId === undefined) return
  batch(() => {
    changeLesson({ questions })
    followed.value = { panelId, ant: questions.ant }
    seen.value = null
    guessMoves.value = 0
    answers.value = []
    revealed.value = null
    lessonMode.value = 'guess'
  })
}

/** The questions leave the link with it. */
export function stopGuessing(): void {
  batch(() => {
    changeLesson({ questions: null })
    stopFollowing()
  })
}

/** From here on everything is shown. */
export function showAll(): void {
  const who = followed.peek()
  changeLesson({ questions: null })
  if (who) follow(who.panelId, who.ant)
}

/** What is asked now: the ant where it stands, with what it may choose from; null while that is not known, or when its walk is over. */
export const question = computed((): AntTurn | null => {
  const now = seen.value
  if (lessonMode.value !== 'guess' || now?.at.moves !== guessMoves.value || now.at.over) return null
  return now.turn && isOpen(now.turn) ? now.turn : null
})

export const optionsOf = ({ moves }: AntTurn): AntMove[] => moves.filter(({ weight }) => weight > 0)

/** A move without a choice is no question. */
const isOpen = (turn: AntTurn) => turn.takes !== null && optionsOf(turn).length > 1

export function guess(guessed: AntMove): void {
  const turn = question.peek()
  const taken = turn?.moves[turn.takes ?? -1]
  if (!turn || !taken || revealed.peek()) return
  const best = Math.max(...turn.moves.map(({ probability }) => probability))
  const answer: Answer = { guessed, taken, best }
  batch(() => {
    answers.value = [...answers.peek(), answer]
    revealed.value = answer
  })
}

export function nextQuestion(): void {
  if (!revealed.peek()) return
  batch(() => {
    revealed.value = null
    guessMoves.value++
  })
}

/** Opens what a link asks, and passes over moves without a choice. */
export function keepAsking(): void {
  effect(() => {
    const questions = lesson.value?.questions
    const panelId = panels.value[questions?.panel ?? -1]?.id
    if (questions && panelId !== undefined && lessonMode.value === null && panelById(panelId))
      begin(questions)
  })
  effect(() => {
    const now = seen.value
    if (lessonMode.value !== 'guess' || now?.at.moves !== guessMoves.value || now.at.over) return
    if (now.turn?.fate === 'walking' && !isOpen(now.turn)) guessMoves.value++
  })
}
