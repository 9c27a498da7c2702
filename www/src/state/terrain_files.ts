/** Rasters of heights: looked at first, then opened as a whole or in part. */
import type { Imported } from '@pkg/formicarium'
import { lateTools } from '../engine/late_tools'
import type { TerrainPart } from '../model/tool_calls'
import { type NamedBytes, type Taker, type TerrainFile, terrainFile } from './offered_files'

/** `check` throws where it is no longer wanted once it has been looked at. */
export async function offerTerrain(
  { bytes, name }: NamedBytes,
  take: Taker | null,
  check: () => void,
): Promise<void> {
  const survey = await lateTools.surveyTerrain(bytes, name)
  check()
  terrainFile.value = { name, bytes, take, survey }
}

/** The file stays offered until it could be read. */
export async function importPart(
  { bytes, name }: TerrainFile,
  part: TerrainPart,
): Promise<Imported> {
  const imported = await lateTools.importTerrain(bytes, name, part)
  terrainFile.value = null
  return imported
}
