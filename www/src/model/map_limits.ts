/** The largest map the page takes, as links and files do. */
export const MOST_CELLS_A_SIDE = 4096
