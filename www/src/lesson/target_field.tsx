/** In the share dialog: the target that the link sets, and what else it carries for a lesson. */
import type { Objective } from '@pkg/formicarium'
import { useState } from 'preact/hooks'
import { t } from '../i18n/lesson'
import type { Target } from '../model/lesson'
import { lesson, objectives, references } from '../state'
import { NumberField, Segmented, Select } from '../ui/fields'
import { referenceValue } from '../words/gap_words'
import { metresPerCell, withUnit } from '../words/metres'
import { objectiveWord } from '../words/objective_words'
import { changeLesson } from './change_lesson'
import { stopWords } from './stop_words'

/** Of a target in metres. */
const DIGITS = 6

const KINDS = ['none', 'number', 'optimum'] as const
type Kind = (typeof KINDS)[number]

export function TargetField() {
  const target = lesson.value?.target ?? null
  const [wrong, setWrong] = useState(false)
  const objective = target?.objective ?? objectives.value[0] ?? 'length'
  const kind = kindOf(target)
  const scale = metresPerCell.value ?? 1
  return (
    <fieldset class="target-field">
      <legend>{t('lesson.target.field')}</legend>
      <div class="target-row">
        <Segmented
          label={t('lesson.target.field')}
          value={kind}
          options={KINDS.map((value) => ({
            value,
            label: t(`lesson.target.kinds.${value}`),
            testId: `target-${value}`,
          }))}
          onChange={(chosen) => {
            setWrong(false)
            changeLesson({ target: targetOf(chosen, objective) })
          }}
        />
        {target && target.beat !== 'optimum' && (
          <NumberField
            label={withUnit(t('lesson.target.value'))}
            value={scale === 1 ? target.beat : Number((target.beat * scale).toPrecision(DIGITS))}
            min={0}
            max={1e9}
            invalid={wrong}
            describedBy={wrong ? 'target-wrong' : undefined}
            testId="target-value"
            live
            onChange={(typed) => {
              const beat = typed / scale
              setWrong(!(beat > 0 && beat <= 1e9))
              if (beat > 0 && beat <= 1e9) changeLesson({ target: { objective, beat } })
            }}
          />
        )}
        {target && choices(objective).length > 1 && (
          <Select
            label={t('lesson.target.objective')}
            value={objective}
            options={choices(objective).map((value) => ({
              value,
              label: t(`objective.${objectiveWord(value)}`),
            }))}
            testId="target-objective"
            onChange={(chosen) => changeLesson({ target: targetOf(kind, chosen) })}
          />
        )}
      </div>
      {wrong && (
        <p id="target-wrong" class="form-error" role="alert">
          {t('lesson.target.wrong')}
        </p>
      )}
      <Carried />
    </fieldset>
  )
}

const kindOf = (target: Target | null): Kind =>
  target === null ? 'none' : target.beat === 'optimum' ? 'optimum' : 'number'

/** The objectives of the page, and the target's own. */
const choices = (own: Objective): Objective[] => [...new Set([own, ...objectives.value])]

/** A number begins a little above the reference, where that is known. */
function targetOf(kind: Kind, objective: Objective): Target | null {
  if (kind === 'none') return null
  if (kind === 'optimum') return { objective, beat: 'optimum' }
  const best = referenceValue(references.peek()[objective] ?? null)
  return { objective, beat: best ? Math.round(best * 105) / 100 : 100 }
}

/** Nothing is shared unseen. */
function Carried() {
  const { stops, drawn, questions } = lesson.value ?? {}
  if (!stops && !drawn && !questions) return null
  return (
    <>
      <p class="hint">{t('lesson.target.inLink')}</p>
      <ul class="share-contents" data-testid="lesson-in-link">
        {stops && (
          <li>{t('lesson.target.carries.stops', { what: stops.map(stopWords).join(', ') })}</li>
        )}
        {drawn && (
          <li>
            {t('lesson.target.carries.drawn', { label: drawn.label, count: drawn.path.length })}
          </li>
        )}
        {questions && (
          <li>
            {t('lesson.target.carries.questions', {
              ant: questions.ant + 1,
              iteration: questions.iteration + 1,
            })}
          </li>
        )}
      </ul>
    </>
  )
}
