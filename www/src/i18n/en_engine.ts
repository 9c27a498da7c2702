/** Where the engine's own words speak of the command line, the page's say what to do here. */
export const enEngine = {
  notices: {
    'matrix-one-is-blocked':
      '0 was read as free and 1 as blocked. If the file means the opposite, choose “Swap walls and free cells” in the map menu.',
  },
}
