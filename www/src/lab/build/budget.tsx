/** How many seeds, and the budget of each run. */
import type { Budget } from '@pkg/formicarium'
import { useId } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { limits } from '../../model/facts'
import { NumberField, Select } from '../../ui/fields'
import { FormError } from '../../ui/form_error'
import { Reserved } from '../../ui/reserved'
import { budget, change, seeds, untilBudget } from './draft'
import { refusalOf } from './refusals'

/** What a budget can count. */
export const AXES = [
  'iterations',
  'constructed-paths',
  'ant-moves',
  'cell-expansions',
  'moves',
] as const
/** About what most planners spend by default, by what is counted. */
const USUAL: Record<Budget['axis'], number> = {
  iterations: 100,
  'constructed-paths': 2000,
  'ant-moves': 100_000,
  'cell-expansions': 100_000,
  moves: 100_000,
}
/** With fewer runs nothing is tested (`FEWEST` in lab/results). */
const FEW_SEEDS = 20

export function BudgetFields() {
  return (
    <fieldset class="builder-part">
      <legend>{t('lab.build.howMany')}</legend>
      <div class="builder-row">
        <NumberField
          label={t('lab.build.seedsCount')}
          value={seeds.value.count}
          min={1}
          max={limits.max_seeds}
          step={1}
          nearest
          testId="seed-count"
          onType={setSeeds}
          onChange={setSeeds}
        />
        <NumberField
          label={t('lab.build.seedsFirst')}
          value={seeds.value.from}
          min={0}
          max={0xffffffff - seeds.value.count}
          step={1}
          nearest
          testId="seed-from"
          onChange={(from) =>
            change(() => {
              seeds.value = { ...seeds.peek(), from }
            })
          }
        />
      </div>
      <Refused field="seeds" />
      <Reserved shown={seeds.value.count < FEW_SEEDS} testId="seeds-hint">
        {t('lab.build.fewSeeds')}
      </Reserved>
      <div class="builder-row">
        <Select
          label={t('lab.build.budget')}
          value={budget.value?.axis ?? 'none'}
          options={(['none', ...AXES] as const).map((value) => ({
            value,
            label: t(`lab.build.budgets.${value}`),
          }))}
          testId="budget-axis"
          onChange={choose}
        />
        {budget.value && <Amount of={budget.value} />}
      </div>
      <Refused field="budget" />
      {budget.value && <UntilBudget />}
    </fieldset>
  )
}

/** Counts while it is typed, as far as it can be read, so that nothing else on the page waits for the field to be left. */
function setSeeds(count: number): void {
  if (!(count >= 1 && count <= limits.max_seeds && Number.isInteger(count))) return
  if (count === seeds.peek().count) return
  change(() => {
    seeds.value = { ...seeds.peek(), count }
  })
}

function choose(axis: Budget['axis'] | 'none'): void {
  change(() => {
    budget.value = axis === 'none' ? null : { axis, amount: USUAL[axis] }
  })
}

function Amount({ of }: { of: Budget }) {
  return (
    <NumberField
      label={t('lab.build.amount')}
      value={of.amount}
      min={1}
      max={Number.MAX_SAFE_INTEGER}
      step={1}
      nearest
      testId="budget-amount"
      onChange={(amount) =>
        change(() => {
          budget.value = { ...of, amount }
        })
      }
    />
  )
}

function UntilBudget() {
  const id = useId()
  return (
    <div class="switch-row">
      <input
        id={id}
        type="checkbox"
        class="switch"
        role="switch"
        checked={untilBudget.value}
        aria-checked={untilBudget.value}
        aria-describedby={`${id}-hint`}
        data-testid="until-budget"
        onChange={(event) => {
          untilBudget.value = event.currentTarget.checked
        }}
      />
      <span>
        <label for={id}>{t('lab.build.untilBudget')}</label>
        <span class="hint" id={`${id}-hint`}>
          {t('lab.build.untilBudgetHint')}
        </span>
      </span>
    </div>
  )
}

function Refused({ field }: { field: string }) {
  const error = refusalOf(field)
  return error && <FormError error={error} />
}
