/** What legends of maps and cursors of charts say. */
import type { Layer } from '@pkg/formicarium'

export const enReading = {
  legend: {
    /** For screen readers. */
    words: '{{name}}: from {{low}} to {{high}}',
    same: 'same scale',
    constant: '{{value}} everywhere',
    nothing: 'no values yet',
    heights: 'Height',
    /** In brackets behind the name; nothing for what has no unit. */
    units: {
      trail: 'τ',
      visits: 'ants',
      heuristic: 'η',
      cost: 'cells',
      density: 'share',
      'initial-trail': 'τ',
      'seed-path': '',
      priority: '',
      scent: 'cells',
      merged: '',
    } satisfies Record<Layer, string>,
    expanded: 'expanded',
    onPath: 'on the path',
    elsewhere: 'elsewhere',
    merged: 'merged',
  },
  cursor: {
    /** How a chart can be operated, for screen readers. */
    convergence: '{{chart}}: arrow keys move the cursor, Enter looks back, + and − zoom',
    profile: '{{chart}}: arrow keys move the cursor, Enter looks into the cell, + and − zoom',
    reset: 'Show all of it',
    picture: 'Take away as a picture',
    iteration: 'Iteration {{iteration}}',
    best: 'Best',
    bestOf: '{{planner}}: best {{best}}',
    valuesOf: '{{planner}}: best {{best}}, iteration best {{iterationBest}}, mean {{mean}}',
    distance: 'After {{distance}} m',
    altitude: 'Altitude',
    cell: 'Cell',
    altitudeOf: '{{planner}}: {{altitude}} m, cell {{x}}, {{y}}',
  },
  lengths: {
    metres: '{{value}} m',
    kilometres: '{{value}} km',
    cells_one: '{{count}} cell',
    cells_other: '{{count}} cells',
    /** A length and its unit, at the head of numbers. */
    inMetres: '{{what}} (m)',
    unit: { metres: 'metres', cells: 'cells' },
    /** For screen readers. */
    bar: 'Scale bar: {{length}}',
    /** Of a cell: in the world, or from the map's corner. */
    place: 'x {{x}}, y {{y}} m',
    fromCorner: '{{x}}, {{y}} m from the lower left corner',
    noData: 'no data',
  },
}
