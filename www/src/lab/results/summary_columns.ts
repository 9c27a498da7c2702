/** The columns of the summary: where each number comes from, how it is written, which way is better. */
import { t } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis, Summary } from '../../model/analysis'
import { gapShown } from '../../words/gap_words'
import { amount, axisWords, dash, effort, measureWords, range, share } from '../words/numbers'

type Write = (value: number) => string

export const COLUMNS = [
  'found',
  'best',
  'median',
  'mean',
  'gap',
  'optimal',
  'effort',
  'ert',
  'turns',
] as const
export type ColumnId = (typeof COLUMNS)[number]

export interface Column {
  id: ColumnId
  better: 'lower' | 'higher' | null
  /** What it is sorted by. */
  value(entry: EntryAnalysis): number | null
  text(entry: EntryAnalysis): string
  /** A second, quieter line. */
  note?(entry: EntryAnalysis): string | null
  /** More about the number, where the pointer rests. */
  hint?(entry: EntryAnalysis): string | null
}

export interface Table {
  analysis: Analysis
  map: MapAnalysis
  /** Which of the map's targets running times are about. */
  target: number
}

export function columnsOf({ analysis, map, target }: Table): Column[] {
  const write = amount(map.measure)
  const spent = effort(analysis.axis)
  const of = (id: ColumnId, key: keyof Summary): Column => ({
    id,
    better: 'lower',
    value: ({ summary }) => summary?.[key] ?? null,
    text: ({ summary }) => dash(summary?.[key], write),
  })
  const all: Column[] = [
    found(),
    of('best', 'least'),
    { ...of('median', 'median'), note: ({ summary }) => summary && quartiles(summary, write) },
    mean(write),
    gap(),
    optimal(),
    {
      id: 'effort',
      better: 'lower',
      value: (e) => e.effort_to_best?.median ?? null,
      text: (e) => dash(e.effort_to_best?.median, spent),
      note: (e) => e.effort_to_best && quartiles(e.effort_to_best, spent),
    },
    runningTime(target, spent),
    turns(),
  ]
  const bounded = map.targets.length > 0
  return all.filter(({ id }) => bounded || !['gap', 'optimal', 'ert'].includes(id))
}

const quartiles = ({ lower, upper }: Summary, write: Write) => range(lower, upper, write)

/** Of an entry that has no runs on the map, nothing. */
const partOf = (part: number, whole: number) =>
  whole > 0 ? t('lab.results.of', { part, whole }) : '–'

/** Runs without a path stand first: nothing that follows says anything of them. */
function found(): Column {
  return {
    id: 'found',
    better: 'higher',
    value: ({ with_path, runs }) => (runs > 0 ? with_path / runs : null),
    text: ({ with_path, runs }) => partOf(with_path, runs),
    note: ({ runs, expected }) =>
      runs < expected ? t('lab.results.ofExpected', { expected }) : null,
    hint: ({ success_interval: interval, runs }) =>
      runs > 0 && interval
        ? t('lab.results.wilson', { low: share(interval[0]), high: share(interval[1]) })
        : null,
  }
}

/** The interval takes ten thousand resamples, so it comes at rest. */
function mean(write: Write): Column {
  return {
    id: 'mean',
    better: 'lower',
    value: ({ summary }) => summary?.mean ?? null,
    text: ({ summary }) =>
      summary ? `${write(summary.mean)} ± ${dash(summary.deviation, write)}` : '–',
    note: ({ mean_interval: mean, summary }) =>
      mean ? range(mean[0], mean[1], write) : summary && '…',
    hint: ({ median_interval: median, summary }) => {
      if (!summary) return null
      if (!median) return t('lab.results.intervalsWait')
      return t('lab.results.medianInterval', { interval: range(median[0], median[1], write) })
    },
  }
}

function gap(): Column {
  return {
    id: 'gap',
    better: 'lower',
    value: ({ gap }) => gap?.median ?? null,
    text: ({ gap }) => dash(gap?.median, gapShown),
    note: ({ gap }) => gap && t('lab.matrix.meanGap', { value: gapShown(gap.mean) }),
  }
}

function optimal(): Column {
  return {
    id: 'optimal',
    better: 'higher',
    value: ({ optimal, runs, proven }) => (proven && runs > 0 ? optimal / runs : null),
    text: ({ optimal, runs, proven }) => (proven ? partOf(optimal, runs) : '–'),
  }
}

function runningTime(target: number, spent: Write): Column {
  const at = ({ running_times }: EntryAnalysis) => running_times[target]
  return {
    id: 'ert',
    better: 'lower',
    value: (e) => at(e)?.expected ?? null,
    text: (e) => dash(at(e)?.expected, spent),
    note: (e) => {
      const time = at(e)
      if (time?.expected == null)
        return t(`lab.matrix.noTime.${e.no_running_time ?? 'not-reached'}`)
      return t('lab.results.hitsShort', { part: time.successes, whole: e.runs })
    },
  }
}

function turns(): Column {
  return {
    id: 'turns',
    better: 'lower',
    value: ({ turns }) => turns?.median ?? null,
    text: ({ turns }) => dash(turns?.median, amount('turns')),
  }
}

/** Its name, what its second line holds, and what both mean. */
export function headOf(id: ColumnId, { analysis, map }: Table) {
  const words = { axis: axisWords(analysis.axis), measure: measureWords(map.measure) }
  return {
    name: t(`lab.results.summary.${id}`),
    note: noteOf(id, words.axis),
    hint: t(`lab.results.summaryHints.${id}`, words),
  }
}

function noteOf(id: ColumnId, axis: string): string | null {
  switch (id) {
    case 'effort':
    case 'ert':
      return axis
    case 'median':
    case 'mean':
    case 'gap':
    case 'turns':
      return t(`lab.results.summaryNotes.${id}`)
    default:
      return null
  }
}
