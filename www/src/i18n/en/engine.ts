/** Where the engine's own words speak of the command line, the page's say what to do here. */
export const enEngine = {
  errors: {
    'too-many-goals': {
      message: 'The map has {{value}} goals; this planner reaches at most {{max}}',
      hint: 'Remove goals, or choose a planner that visits several',
    },
    ground: {
      message: 'This planner does not plan {{ground}}',
      hint: 'Choose another planner, or change how one moves in the map menu',
    },
    place: { message: '“{{value}}” is no place', hint: 'Write column and row, as in 11, 4' },
  },
  grounds: {
    plane: 'on a plane',
    surface: 'on the surface of a terrain',
    sixteen: 'with 16 moves',
    slices: 'by slices',
  },
  notices: {
    'matrix-one-is-blocked':
      '0 was read as free and 1 as blocked. If the file means the opposite, choose “Swap walls and free cells” in the map menu.',
    'terrain-cell-size':
      'The file does not say how large its cells are: 1 m is assumed; change it in “Size, moves and terrain…”.',
  },
}
