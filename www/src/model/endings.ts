/** Endings of files of which maps are made, as a file picker offers them first. */
export const MAP_ENDINGS = [
  '.map,.txt,.csv,.json,.m,.py',
  '.png,.jpg,.jpeg,.webp,.bmp,.pgm,.pbm,.ppm',
  '.yaml,.yml,.asc,.tif,.tiff,.hgt,.zip,.gz',
].join()
