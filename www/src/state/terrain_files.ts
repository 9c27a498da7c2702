/** Rasters of heights: looked at first, then opened as a whole or in part. */
import type { Imported, Survey } from '@pkg/formicarium'
import { signal } from '@preact/signals'
import { tools } from '../engine/tools'
import type { TerrainPart } from '../model/tool_calls'

export interface TerrainFile {
  name: string
  bytes: Uint8Array
  survey: Survey
}

/** A raster that waits for the reader to say which part of it to open. */
export const terrainFile = signal<TerrainFile | null>(null)

export async function offerTerrain(bytes: Uint8Array, name: string): Promise<void> {
  terrainFile.value = { name, bytes, survey: await tools.surveyTerrain(bytes, name) }
}

/** The file stays offered until it could be read. */
export async function importPart(
  { bytes, name }: TerrainFile,
  part: TerrainPart,
): Promise<Imported> {
  const imported = await tools.importTerrain(bytes, name, part)
  terrainFile.value = null
  return imported
}
