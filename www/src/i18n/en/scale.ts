/** How large cells are and how fast one moves: of the dialog “Size, moves and robot”. */
export const enScale = {
  title: 'Scale and speed',
  cell: 'Cell size (m)',
  speed: 'Speed (m/s)',
  turn: 'Time for a turn (s)',
  whole: 'The map measures {{x}} × {{y}}.',
  time: 'Travel time = metres / speed + turns · time for a turn.',
  unit: 'Lengths in',
  units: { metres: 'Metres', cells: 'Cells' },
  none: 'A map with cells of 1 m and no place in the world has no scale: its lengths are in cells.',
  slices: 'By slices lengths are made of cells and levels, so they are not in metres.',
}
