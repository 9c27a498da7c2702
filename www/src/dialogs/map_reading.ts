/** A map, read anew while the reader chooses. */
import type { Imported, ReadOptions } from '@pkg/formicarium'
import type { MapFile } from '../state'
import { readMap } from '../state/open_files'
import { type Latest, useLatest } from './latest_answer'

/** `options` null: nothing can be read yet. */
export function useReading(file: MapFile, options: ReadOptions | null): Latest<Imported> {
  return useLatest(JSON.stringify(options), options && (() => readMap(file, options)))
}
