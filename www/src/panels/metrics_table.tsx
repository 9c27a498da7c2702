/**
 * Every panel's numbers side by side; the better one of a measure stands out. Two panels are columns. More have a row each, so that none
 * is out of sight: with few numbers, and all the others beneath on demand.
 */
import { signal } from '@preact/signals'
import { ChevronDown, ChevronRight } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useEffect } from 'preact/hooks'
import { t } from '../i18n/column'
import { byHand, type Panel, panels, slotColour } from '../state'
import { keepCertificates } from '../state/certificates'
import { keepCurves } from '../state/curves'
import { Icon } from '../ui/icon'
import { unitName, withUnit } from '../words/metres'
import { panelTitle } from '../words/planner_words'
import { type Measure, measuresOf } from './measures'

const MOST_COLUMNS = 2
/** As many columns of numbers as a narrow column has room for beside names. */
const TOGETHER = 3
/** Those that are always seen are the first of these that there are: what a planner may be measured by comes first. */
const FIRST: Measure['id'][] = ['gap', 'walkedWeight', 'levelCost', 'cost', 'length', 'turns']

const showsAll = signal(false)

export function MetricsTable() {
  useEffect(keepCurves, [])
  useEffect(keepCertificates, [])
  const all = [...panels.value, ...byHand.value]
  const measures = measuresOf(all)
  if (all.length <= MOST_COLUMNS)
    return (
      <Scrolled>
        <ByMeasure all={all} measures={measures} />
      </Scrolled>
    )
  const first = measures
    .filter(({ id }) => FIRST.includes(id))
    .sort(byRank)
    .slice(0, TOGETHER)
  const others = measures.filter((measure) => !first.includes(measure))
  return (
    <Scrolled>
      <ByPanel all={all} measures={first} />
      <button
        type="button"
        class="fold"
        aria-expanded={showsAll.value}
        data-testid="all-metrics"
        onClick={() => {
          showsAll.value = !showsAll.value
        }}
      >
        <Icon icon={showsAll.value ? ChevronDown : ChevronRight} size={14} />
        {t('metrics.all')}
      </button>
      {showsAll.value &&
        together(others).map((some) => <ByPanel key={some[0]?.id} all={all} measures={some} />)}
    </Scrolled>
  )
}

const byRank = (a: Measure, b: Measure) => FIRST.indexOf(a.id) - FIRST.indexOf(b.id)

function Scrolled({ children }: { children: ComponentChildren }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="table-scroll" tabIndex={0} aria-label={t('metrics.title')}>
      {children}
    </section>
  )
}

/** Numbers beside numbers; words have a table of their own. */
function together(measures: Measure[]): Measure[][] {
  const tables: Measure[][] = []
  for (const measure of measures) {
    const last = tables.at(-1)
    const joins = last && last.length < TOGETHER && !measure.wordy && !last[0]?.wordy
    if (joins) last.push(measure)
    else tables.push([measure])
  }
  return tables
}

interface TableProps {
  all: Panel[]
  measures: Measure[]
}

function ByMeasure({ all, measures }: TableProps) {
  return (
    <table class="metrics">
      <Caption />
      <thead>
        <tr>
          <td />
          {all.map((panel) => (
            <PanelHead key={panel.id} panel={panel} scope="col" />
          ))}
        </tr>
      </thead>
      <tbody>
        {measures.map((measure) => (
          <tr key={measure.id} class={measure.id === 'gap' ? 'leading' : undefined}>
            <MeasureHead of={measure} scope="row" />
            {all.map((panel, index) => (
              <Cell key={panel.id} measure={measure} index={index} />
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  )
}

function ByPanel({ all, measures }: TableProps) {
  return (
    <table class="metrics by-panel">
      <Caption />
      <thead>
        <tr>
          <td />
          {measures.map((measure) => (
            <MeasureHead key={measure.id} of={measure} scope="col" />
          ))}
        </tr>
      </thead>
      <tbody>
        {all.map((panel, index) => (
          <tr key={panel.id}>
            <PanelHead panel={panel} scope="row" />
            {measures.map((measure) => (
              <Cell key={measure.id} measure={measure} index={index} />
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  )
}

const Caption = () => <caption class="visually-hidden">{t('metrics.caption')}</caption>

function PanelHead({ panel, scope }: { panel: Panel; scope: 'row' | 'col' }) {
  return (
    <th scope={scope} style={{ '--panel-colour': slotColour(panel.slot) }}>
      <span class="panel-dot" aria-hidden="true" />
      {panelTitle(panel.id) || panel.setup.planner}
    </th>
  )
}

const MeasureHead = ({ of: { id, isLength }, scope }: { of: Measure; scope: 'row' | 'col' }) => (
  <th scope={scope} title={t(`metrics.hints.${id}`, { unit: unitName() })}>
    {isLength ? withUnit(t(`metrics.${id}`)) : t(`metrics.${id}`)}
  </th>
)

function Cell({ measure: { id, wordy, cells }, index }: { measure: Measure; index: number }) {
  const cell = cells[index]
  return (
    <td
      class={wordy ? id : cell?.better ? 'better' : undefined}
      title={cell?.why}
      data-testid={`metric-${id}-${index + 1}`}
      data-value={cell?.value ?? (wordy ? undefined : '')}
    >
      <span>{cell?.text}</span>
      {cell?.why && <span class="visually-hidden"> {cell.why}</span>}
      {cell?.note && <span class={cell.quiet ? 'cell-note quiet' : 'cell-note'}>{cell.note}</span>}
    </td>
  )
}
