/** The question, what it was worth to guess so, and the score with what anybody could expect. */
import { RotateCcw } from 'lucide'
import { numbers } from '../i18n'
import { t } from '../i18n/lesson'
import { byDirection, MoveTable, percent } from '../playback'
import { Button } from '../ui/buttons'
import { panelTitle } from '../words/planner_words'
import { antCount } from './ant_card'
import { Card } from './card'
import { followed, seen } from './follow'
import {
  guess,
  guessAgain,
  guessNextAnt,
  nextQuestion,
  optionsOf,
  question,
  showAll,
  stopGuessing,
} from './guess'
import { chooseByNumber } from './guess_input'
import { movesOfTurn } from './move_rows'
import { answers, askedAbout, guessMoves, revealed } from './questions'
import { type Answer, isRight, scoreOf } from './score'

export function GuessCard() {
  const who = followed.value
  const asked = askedAbout.value
  if (!who || !asked) return null
  const { whole } = numbers.value
  const where = t('lesson.guess.where', {
    planner: panelTitle(who.panelId),
    iteration: whole.format(asked.iteration + 1),
    move: whole.format(guessMoves.value + 1),
  })
  return (
    <Card
      title={t('lesson.guess.title', { ant: who.ant + 1 })}
      line={where}
      panelId={who.panelId}
      testId="guess-card"
      onClose={stopGuessing}
      onKey={({ key }) => chooseByNumber(key)}
    >
      <Actions panelId={who.panelId} ant={who.ant} />
      <p class="hint">{where}</p>
      <div role="status">{revealed.value ? <Told answer={revealed.value} /> : <Asked />}</div>
      <ScoreLine />
    </Card>
  )
}

function Asked() {
  const turn = question.value
  if (!turn) return <p data-testid="guess-over">{whyNoQuestion()}</p>
  return (
    <>
      <p>{t('lesson.guess.how')}</p>
      <div class="options">
        {optionsOf(turn).map((move, index) => (
          <button
            key={move.to.join()}
            type="button"
            class="button plain"
            data-testid="guess-option"
            data-to={move.to.join()}
            onClick={() => guess(move)}
          >
            {t('lesson.guess.option', { number: index + 1, x: move.to[0], y: move.to[1] })}
          </button>
        ))}
      </div>
    </>
  )
}

function whyNoQuestion(): string {
  const now = seen.value
  if (now && !now.turn) return t('lesson.ant.none')
  if (now?.turn?.fate === 'arrived') return t('lesson.guess.arrived')
  if (now?.turn?.fate === 'lost') return t('lesson.guess.lost')
  return t('lesson.ant.wait')
}

/** All probabilities, and where the ant went. */
function Told({ answer }: { answer: Answer }) {
  const turn = seen.value?.turn
  const { taken, guessed, best } = answer
  const [x, y] = taken.to
  const right = isRight(answer)
  const at = turn?.way.at(-1) ?? [0, 0]
  const rows = turn ? byDirection(movesOfTurn(turn), at) : []
  const marked = rows.find((row) => row.x === x && row.y === y && row.level === taken.level)
  return (
    <>
      <p class={right ? 'guess-right' : 'guess-wrong'} data-testid="guess-told" data-right={right}>
        {t(right ? 'lesson.guess.right' : 'lesson.guess.wrong', {
          x,
          y,
          share: percent(guessed.probability),
        })}{' '}
        {t('lesson.guess.likeliest', { share: percent(best) })}
      </p>
      <MoveTable moves={rows} cell={at} level={turn?.level ?? 0} marked={marked ?? null} />
    </>
  )
}

function ScoreLine() {
  const score = scoreOf(answers.value)
  if (!score) return <p class="hint">{t('lesson.guess.noScore')}</p>
  const { right, count, yours, best } = score
  return (
    <p
      class="guess-score"
      data-testid="guess-score"
      data-right={right}
      data-count={count}
      data-yours={yours}
      data-best={best}
    >
      <strong>{t('lesson.guess.score', { right, count })}</strong>{' '}
      {t('lesson.guess.yours', { share: percent(yours) })}{' '}
      {t('lesson.guess.best', { share: percent(best) })}
    </p>
  )
}

/** Above all that changes, so that no press for the next move is taken as a guess. */
function Actions({ panelId, ant }: { panelId: number; ant: number }) {
  return (
    <div class="card-actions">
      <Button
        label={t('lesson.guess.next')}
        tone="primary"
        testId="guess-next"
        disabled={revealed.value === null}
        onClick={nextQuestion}
      />
      <Button
        icon={RotateCcw}
        label={t('lesson.guess.again')}
        tone="quiet"
        testId="guess-again"
        disabled={guessMoves.value === 0 && answers.value.length === 0}
        onClick={guessAgain}
      />
      <Button
        label={t('lesson.guess.nextAnt')}
        tone="quiet"
        testId="guess-next-ant"
        disabled={ant + 1 >= antCount(panelId)}
        onClick={guessNextAnt}
      />
      <Button
        label={t('lesson.guess.follow')}
        tone="quiet"
        testId="guess-follow"
        onClick={showAll}
      />
    </div>
  )
}
