/** A map, read anew while the reader chooses. */
import type { Imported, ReadOptions } from '@pkg/formicarium'
import { boxOfKnown, croppedTo } from '../model/crop'
import type { MapFile } from '../state'
import { readMap } from '../state/open_files'
import { type Latest, useLatest } from './latest_answer'

/** `options` null: nothing can be read yet. */
export function useReading(
  file: MapFile,
  options: ReadOptions | null,
  knownOnly: boolean,
): Latest<Imported> {
  return useLatest(
    JSON.stringify([options, knownOnly]),
    options && (() => readPart(file, options, knownOnly)),
  )
}

/** All of it, or of a robot's map what it knows. */
export async function readPart(
  file: MapFile,
  options: ReadOptions,
  knownOnly: boolean,
): Promise<Imported> {
  if (!knownOnly) return readMap(file, options)
  const unknown = options.unknown === 'free' ? 'blocked' : 'free'
  const [map, other] = await Promise.all([
    readMap(file, options),
    readMap(file, { ...options, unknown }),
  ])
  const box = boxOfKnown(map.cells, other.cells, map.spec.width)
  return box ? croppedTo(map, box) : map
}
