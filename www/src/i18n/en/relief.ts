/** Looking at terrains: from above, in three dimensions, along a path. */
export const enRelief = {
  relief: {
    group: 'View of the terrain',
    flat: '2-D',
    flatHint: 'See the map from above',
    solid: '3-D',
    solidHint: 'See the terrain in three dimensions',
    contours: 'Contour lines',
    stretch: 'Heights',
    stretchTimes: '{{times}} times as high',
    label:
      'Terrain {{name}} in three dimensions, {{width}} by {{height}} cells. Arrow keys turn it, plus and minus zoom.',
    help: 'With Shift, arrow keys move the cell cursor; with the tools for start and goals it is the other way round, and Enter puts them down. Page Up and Page Down change levels, Home shows the whole map, 3 returns to the flat map.',
    opened: 'The terrain is shown in three dimensions',
    reset: 'The whole terrain is in view',
    wallsFlat: 'Walls are drawn on the flat map',
    missing: 'This browser cannot draw in three dimensions',
    missingHint: 'It offers no WebGL. The flat map has everything else.',
    lost: 'The picture in three dimensions was lost',
    lostHint: 'The graphics card was needed elsewhere. The flat map goes on; press 3 to try again.',
    cell: '{{x}}, {{y}}',
    withHeight: '{{words}}, {{height}}',
  },
  profile: {
    charts: 'Charts',
    title: 'Elevation profile',
    distance: 'Distance (m)',
    altitude: 'Altitude (m)',
    empty: 'How a path goes up and down appears here as soon as one is found.',
    words: '{{planner}}: {{length}} m long, {{climb}} m up, {{descent}} m down',
    ground: 'Ground below {{planner}}',
  },
}
