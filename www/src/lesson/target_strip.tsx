/** The target in one line, and who has beaten it. */
import { t } from '../i18n/lesson'
import { lesson } from '../state'
import { lengthShown } from '../words/lengths'
import { objectiveWord } from '../words/objective_words'
import { type Standing, standing, targetValue } from './target'

export function TargetStrip() {
  const target = lesson.value?.target
  const now = standing.value
  if (!target || !now) return null
  const what = t(`objective.${objectiveWord(target.objective)}`)
  const value = targetValue.value
  const number = value === null ? '' : lengthShown(value)
  const optimum = value === null ? 'lesson.target.optimum' : 'lesson.target.optimumAt'
  const key = target.beat === 'optimum' ? optimum : 'lesson.target.number'
  return (
    <section
      class="target-strip"
      aria-label={t('lesson.target.region')}
      data-testid="target-strip"
      data-standing={now.kind}
    >
      <strong>{t(key, { value: number, what })}</strong>
      <span role="status">{standingWords(now)}</span>
    </section>
  )
}

function standingWords(now: Standing): string {
  if (!('who' in now)) return t(`lesson.target.${now.kind}`)
  return t(`lesson.target.${now.kind}`, {
    who: now.who,
    value: lengthShown(now.value),
    by: lengthShown(now.by),
  })
}
