/** Panels and tools on the whole engine; only it has file formats and generators. */
import * as engine from '@pkg/formicarium'
import { numbersOf } from '../model/cell_numbers'
import type { DriveCalls } from '../model/drive_calls'
import type { LessonCalls } from '../model/lesson_calls'
import type { OrderCalls } from '../model/order_calls'
import type { MapCalls, ToolCalls } from '../model/tool_calls'
import { driveCalls } from './drive_calls'
import { toolCalls } from './engine_calls'
import { lessonCalls } from './lesson_calls'
import { orderCalls } from './order_calls'
import { serve } from './serve_worker'
import { traceContours } from './terrain_contours'
import { groundOf } from './whole_ground'

const calls: ToolCalls & MapCalls & OrderCalls & LessonCalls & DriveCalls = {
  ...toolCalls(engine),
  ...orderCalls(engine),
  ...lessonCalls(engine),
  ...driveCalls(engine),
  importMap: (bytes, name, options, image) => engine.import_map(bytes, name, options, image),
  importScen: (bytes) => engine.import_scen(bytes),
  recognise: (bytes, name) => engine.recognise(bytes, name),
  listMatrices: (bytes) => engine.list_matrices(bytes),
  rosImage: (yaml) => engine.ros_image(yaml),
  unpack: (bytes, name) => engine.unpack(bytes, name),
  showPicture: (bytes, most) => engine.show_picture(bytes, most),
  findFigure: (bytes) => engine.find_figure(bytes),
  readFigure: (bytes, lattice) => engine.read_figure(bytes, lattice),
  figureMap: (classes, columns, name) => engine.figure_map(classes, columns, name),
  surveyTerrain: (bytes, name) => engine.survey_terrain(bytes, name),
  importTerrain: (bytes, name, { crop, size }) => engine.import_terrain(bytes, name, crop, size),
  fittingSlices: (...asked) => engine.fitting_slices(...asked),
  feltMap(...map) {
    const { blocked, factors } = engine.felt_map(...map)
    return { blocked, factors: numbersOf(factors) }
  },
  weightColours: (theme) => engine.weight_colors(theme),
  exportRos: (spec, cells, image) => engine.export_ros(spec, cells, image),
  exportGeotiff: (...map) => engine.export_geotiff(...map),
  pathFormats: (spec) => engine.path_formats(spec),
  writePath: (map, { path, altitudes, objective }, format) =>
    engine.write_path(...map, path, Float32Array.from(altitudes ?? []), objective, format),
  readPath: (spec, bytes) => engine.read_path(spec, bytes),
  ablation: (planner, preset, set) => engine.ablation(planner, preset, set),
  joinResults: (document, bytes, name, instance, leaveOut) =>
    engine.join_results(document, bytes, name, instance, leaveOut),
  matchResults: (document, bytes, name) => engine.match_results(document, bytes, name),
  resultsTemplate: (document) => engine.results_template(document),
  contours: traceContours,
  mapColours: (layer, theme) => engine.map_colors(layer, theme),
  exportMap: (...asked) => engine.export_map(...asked),
  generate: (kind, width, height, seed, density) =>
    engine.generate(kind, width, height, seed, density),
}

serve(engine, calls, groundOf)
