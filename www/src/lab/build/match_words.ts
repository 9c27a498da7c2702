/** Says whose runs a file of results holds, on which maps, and what was left out. */
import type { ResultsMatch } from '@pkg/formicarium'
import { describeNotice } from '../../i18n/errors'
import { t } from '../../i18n/lab'
import { listed } from '../../i18n/lists'

/** More entries or maps than these are only counted. */
const MOST_NAMED = 4

/** `Rows read, for whom, on which maps`: each a sentence. */
export function toldOf({ matched, warnings }: ResultsMatch, leaveOut: string[]): string[] {
  const { entries, maps, runs } = matched
  const left = maps.filter(({ name }) => leaveOut.includes(name))
  const used = maps.filter(({ name }) => !leaveOut.includes(name))
  const withPath = entries.reduce((sum, entry) => sum + entry.with_path, 0)
  return [
    t('lab.imported.read', { count: runs, withPath }),
    t('lab.imported.entriesRead', {
      count: entries.length,
      names: named(entries.map(({ label }) => label)),
    }),
    ...(used.length > 0
      ? [
          t('lab.imported.mapsRead', {
            count: used.length,
            names: named(used.map(({ name, instance }) => pair(name, instance))),
          }),
        ]
      : []),
    ...left.map(({ name, runs: count }) => t('lab.imported.leftOut', { count, name })),
    ...warnings.map(describeNotice),
  ]
}

/** The match with the map that the reader chose for runs whose map is unknown. */
export function onMap({ matched, warnings }: ResultsMatch, instance: string): ResultsMatch {
  const { maps, runs } = matched
  const chosen =
    maps.length === 0
      ? [{ name: instance, runs, instance }]
      : maps.map((map) => (map.instance === null ? { ...map, instance } : map))
  return { matched: { ...matched, maps: chosen }, warnings }
}

/** A name of the file, and what it is here where that is called otherwise. */
const pair = (name: string, instance: string | null) =>
  instance === null || instance === name ? name : `${name} → ${instance}`

function named(names: string[]): string {
  const shown = listed(names.slice(0, MOST_NAMED))
  const more = names.length - MOST_NAMED
  return more > 0 ? t('lab.imported.andMore', { shown, count: more }) : shown
}
