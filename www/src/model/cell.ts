/** A cell of a map: column and row, from the upper left corner. */
export type Cell = [x: number, y: number]
