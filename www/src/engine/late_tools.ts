/** The whole engine's calls that no first visit makes: files, colours, imported results. */
import type { ExportFormat, PathFormat } from '@pkg/formicarium'
import type { ParamValues } from '../model/messages'
import type { Scenario } from '../model/session'
import type { FoundPath, MapCalls, TerrainPart } from '../model/tool_calls'
import { mapOf, wholeBox } from './tools'

export const lateTools = {
  /** Tells of the matrices that a text holds. */
  listMatrices: (bytes: Uint8Array) => wholeBox().call('listMatrices', bytes),
  /** The name of the picture that belongs to the description of a ROS map. */
  rosImage: (bytes: Uint8Array) => wholeBox().call('rosImage', bytes),
  /** Tells what a raster of heights holds, before it is opened. */
  surveyTerrain: (bytes: Uint8Array, name: string) => wholeBox().call('surveyTerrain', bytes, name),
  importTerrain: (bytes: Uint8Array, name: string, part: TerrainPart) =>
    wholeBox().call('importTerrain', bytes, name, part),
  exportMap: (map: Scenario, format: ExportFormat) =>
    wholeBox().call('exportMap', ...mapOf(map), format),
  exportRos: ({ spec, cells }: Scenario, image: string) =>
    wholeBox().call('exportRos', spec, cells, image),
  exportGeotiff: (map: Scenario) => wholeBox().call('exportGeotiff', ...mapOf(map)),
  /** Every format of paths, with why a map cannot give it. */
  pathFormats: (spec: Scenario['spec']) => wholeBox().call('pathFormats', spec),
  /** The text of a path for other programs. */
  writePath: (map: Scenario, found: FoundPath, format: PathFormat) =>
    wholeBox().call('writePath', mapOf(map), found, format),
  /** The path that a file holds, by steps on this map. */
  readPath: (spec: Scenario['spec'], bytes: Uint8Array) => wholeBox().call('readPath', spec, bytes),
  /** The entries of an ablation, each with its part in it. */
  ablation: (planner: string, preset: string | null, set: ParamValues) =>
    wholeBox().call('ablation', planner, preset, set),
  /** The comparison with the entries of a result file; see the engine's `join_results`. */
  joinResults: (
    document: string,
    bytes: Uint8Array,
    name: string,
    instance: string | null,
    leaveOut: string[],
  ) => wholeBox().call('joinResults', document, bytes, name, instance, leaveOut),
  /** Whose runs a result file holds, and on which of the comparison's maps. */
  matchResults: (document: string, bytes: Uint8Array, name: string) =>
    wholeBox().call('matchResults', document, bytes, name),
  /** An empty table of results for the comparison's maps and seeds. */
  resultsTemplate: (document: string) => wholeBox().call('resultsTemplate', document),
  /** What the colours of maps and layers are; see `MapCalls.mapColours`. */
  mapColours: (...look: Parameters<MapCalls['mapColours']>) =>
    wholeBox().call('mapColours', ...look),
  contours: (...ground: Parameters<MapCalls['contours']>) => wholeBox().call('contours', ...ground),
  /** The map as the robot feels it; see `MapCalls.feltMap`. */
  feltMap: (map: Scenario) => wholeBox().call('feltMap', ...mapOf(map)),
  weightColours: (theme: Parameters<MapCalls['weightColours']>[0]) =>
    wholeBox().call('weightColours', theme),
}
