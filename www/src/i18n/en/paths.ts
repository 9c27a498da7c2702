import type { PathFormat } from '@pkg/formicarium'

/** Paths as files for other programs. */
export const enPaths = {
  saveAs: 'Save path as',
  none: 'There is no path yet.',
  title: 'Path',
  whose: 'Planner',
  as: 'Save as',
  save: 'Save path',
  formats: {
    'path-csv': {
      name: 'Table (CSV)',
      note: 'Cells and metres, a place a line.',
    },
    'path-json': {
      name: 'JSON',
      note: 'Cells and metres, with the size of the map, its frame and the length.',
    },
    'nav-msgs': {
      name: 'ROS 2 path (YAML)',
      note: 'nav_msgs/msg/Path: poses in metres, each turned to the next.',
    },
    geojson: {
      name: 'GeoJSON',
      note: 'A line in the map’s coordinate system, for QGIS and its kin.',
    },
    svg: {
      name: 'Drawing (SVG)',
      note: 'Walls, start, goals, the path and a scale.',
    },
  } satisfies Record<PathFormat, { name: string; note: string }>,
}
