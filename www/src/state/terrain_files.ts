/** Rasters of heights: looked at first, then opened as a whole or in part. */
import type { Imported } from '@pkg/formicarium'
import { tools } from '../engine/tools'
import type { TerrainPart } from '../model/tool_calls'
import { type NamedBytes, type Taker, type TerrainFile, terrainFile } from './offered_files'

export async function offerTerrain({ bytes, name }: NamedBytes, take: Taker | null): Promise<void> {
  terrainFile.value = { name, bytes, take, survey: await tools.surveyTerrain(bytes, name) }
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
