/** Words of pictures that leave the page, and of the dialog that makes them. */
export const enPictures = {
  pictures: {
    title: 'Take away a picture',
    kind: 'Picture',
    kinds: { map: 'Map', convergence: 'Convergence', profile: 'Profile' },
    whose: 'On the map',
    all: 'All paths on the bare map',
    one: '{{planner}} with its layer',
    ground: 'Colours',
    grounds: { page: 'As on the page', print: 'For print (white)' },
    svg: 'SVG',
    png: 'PNG {{scale}}×',
    nothing: 'There is nothing to draw yet. Let the planners run, then come back.',
    preview: 'Preview of the picture',
    seed: 'Seed {{seed}}',
    iteration: 'Iteration {{iteration}}',
    noPath: '{{name}}: no path',
    noPathYet: '{{name}}: no path yet',
    withLength: '{{name}}: {{length}}',
    withGap: '{{name}}: {{length}} ({{gap}})',
    contours: 'Contour lines every {{interval}}.',
    noData: 'Hatched: no data.',
    cellsArePicture:
      'The cells are a PNG picture inside this file: as single shapes they would be too many.',
  },
}
