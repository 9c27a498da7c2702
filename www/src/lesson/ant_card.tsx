/** One ant: where it stands, what it weighs, what it did last, and a look at what it does next. */
import type { AntTurn } from '@pkg/formicarium'
import { ChevronLeft, ChevronRight, Footprints, Undo2 } from 'lucide'
import { numbers } from '../i18n'
import { t } from '../i18n/lesson'
import { byDirection, MoveTable, percent } from '../playback'
import { latest, lookedAt, panelById, panels, plannerEntry, scenario } from '../state'
import { Button, IconButton } from '../ui/buttons'
import { NumberField, Select } from '../ui/fields'
import { panelTitle } from '../words/planner_words'
import { Card } from './card'
import { ahead, follow, followed, type Seen, seen, stopFollowing } from './follow'
import { startGuessing } from './guess'
import { movesOfTurn } from './move_rows'

export function AntCard() {
  const who = followed.value
  if (!who) return null
  const now = seen.value?.panelId === who.panelId && seen.value.ant === who.ant ? seen.value : null
  return (
    <Card
      title={t('lesson.ant.title', { ant: who.ant + 1 })}
      line={now ? standingWords(now) : t('lesson.ant.wait')}
      panelId={who.panelId}
      testId="ant-card"
      onClose={stopFollowing}
    >
      <Choice panelId={who.panelId} ant={who.ant} />
      <Actions panelId={who.panelId} ant={who.ant} now={now} />
      {now ? <Known now={now} /> : <p class="hint">{t('lesson.ant.wait')}</p>}
    </Card>
  )
}

function standingWords({ at, panelId }: Seen): string {
  const { whole } = numbers.value
  return t('lesson.ant.where', {
    planner: panelTitle(panelId),
    iteration: whole.format(at.iteration + 1),
    moves: whole.format(at.moves),
  })
}

/** How many ants there are; with several goals on each leg so many. */
export function antCount(panelId: number): number {
  const legs = scenario.value?.spec.goals.length ?? 1
  return (panelById(panelId)?.live.value.summary?.ants ?? 1) * legs
}

function Choice({ panelId, ant }: { panelId: number; ant: number }) {
  const count = antCount(panelId)
  const colonies = panels.value.filter(
    ({ setup }) => plannerEntry(setup.planner)?.family === 'ant-colony',
  )
  return (
    <div class="ant-choice">
      {colonies.length > 1 && (
        <Select
          label={t('panels.planner')}
          hideLabel
          value={String(panelId)}
          testId="ant-panel"
          options={colonies.map(({ id }) => ({ value: String(id), label: panelTitle(id) }))}
          onChange={(id) => follow(Number(id), 0)}
        />
      )}
      <IconButton
        icon={ChevronLeft}
        label={t('lesson.ant.earlier')}
        tone="quiet"
        size={16}
        testId="ant-earlier"
        disabled={ant === 0}
        onClick={() => follow(panelId, ant - 1)}
      />
      <NumberField
        label={t('lesson.ant.choose')}
        hideLabel
        value={ant + 1}
        min={1}
        max={count}
        step={1}
        nearest
        testId="ant-number"
        onChange={(number) => follow(panelId, number - 1)}
      />
      <span>{t('lesson.ant.of', { count: numbers.value.whole.format(count) })}</span>
      <IconButton
        icon={ChevronRight}
        label={t('lesson.ant.later')}
        tone="quiet"
        size={16}
        testId="ant-later"
        disabled={ant + 1 >= count}
        onClick={() => follow(panelId, ant + 1)}
      />
    </div>
  )
}

function Known({ now }: { now: Seen }) {
  const { turn, at, last, panelId } = now
  return (
    <>
      <p
        class="hint"
        data-testid="ant-where"
        data-moves={at.moves}
        data-iteration={at.iteration}
        data-at={turn?.way.at(-1)?.join()}
      >
        {standingWords(now)}
      </p>
      <p role="status" data-testid="ant-ahead" data-ahead={now.ahead}>
        {now.ahead > 0 && <strong>{t('lesson.ant.ahead', { count: now.ahead })}</strong>}
      </p>
      {last && (
        <p data-testid="ant-last" data-to={last.to.join()}>
          {t('lesson.ant.last', { x: last.to[0], y: last.to[1], share: percent(last.probability) })}
        </p>
      )}
      {turn ? <Turn turn={turn} /> : <p data-testid="ant-none">{whyNone(panelId)}</p>}
      <p class="hint">
        {t('lesson.ant.stepHint')}
        <Agreement now={now} />
      </p>
    </>
  )
}

/** The copy is held against the run where both stand at the end of the same iteration. */
function Agreement({ now }: { now: Seen }) {
  const { summary } = latest(now.panelId)
  if (lookedAt.value !== null || summary?.iteration !== now.at.iteration) return null
  const agrees = summary.digest === now.at.digest
  return (
    <span class={agrees ? 'agrees' : 'differs'} data-testid="ant-agrees" data-agrees={agrees}>
      {' '}
      {t(agrees ? 'lesson.ant.agrees' : 'lesson.ant.differs', { digest: now.at.digest })}
    </span>
  )
}

function whyNone(panelId: number): string {
  const panel = panelById(panelId)
  const family = plannerEntry(panel?.setup.planner ?? '')?.family
  if (family !== 'ant-colony') return t('lesson.ant.noAnts')
  const ended = panel?.live.value.summary?.status !== 'running' && lookedAt.value === null
  return t(ended ? 'lesson.ant.ended' : 'lesson.ant.none')
}

function Turn({ turn }: { turn: AntTurn }) {
  const at = turn.way.at(-1) ?? [0, 0]
  if (turn.fate !== 'walking') {
    const steps = numbers.value.whole.format(turn.way.length - 1)
    return <p data-testid="ant-fate">{t(`lesson.ant.${turn.fate}`, { moves: steps })}</p>
  }
  const isOpen = turn.moves.some(({ weight }) => weight > 0)
  return (
    <>
      {!isOpen && (
        <p data-testid="ant-dead-end">
          {t(turn.next ? 'lesson.ant.deadEnd' : 'lesson.ant.gaveUp')}
        </p>
      )}
      <MoveTable moves={byDirection(movesOfTurn(turn), at)} cell={at} level={turn.level} />
    </>
  )
}

/** Above all that changes: what is pressed again and again stays where it is. */
function Actions({ panelId, ant, now }: { panelId: number; ant: number; now: Seen | null }) {
  const turn = now?.turn
  return (
    <div class="card-actions">
      <Button
        icon={Footprints}
        label={t('lesson.ant.step')}
        testId="ant-step"
        disabled={turn?.fate !== 'walking' || now?.at.over}
        onClick={() => ahead.value++}
      />
      <IconButton
        icon={Undo2}
        label={t('lesson.ant.back')}
        tone="quiet"
        testId="ant-back"
        disabled={!now?.ahead}
        onClick={() => {
          ahead.value = 0
        }}
      />
      <Button
        label={t('lesson.ant.guess')}
        tone="quiet"
        testId="ant-guess"
        disabled={!turn}
        onClick={() => startGuessing(panelId, ant)}
      />
    </div>
  )
}
