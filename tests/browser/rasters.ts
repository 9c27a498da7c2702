/** Small rasters of heights in every format that the page opens. */

/** 6 × 5 heights; without data in the lower left corner. */
export const HEIGHTS = [
  [10, 12, 15, 20, 22, 25],
  [11, 14, 18, 24, 26, 28],
  [12, 16, 30, 35, 30, 29],
  [-9999, 15, 28, 33, 31, 27],
  [-9999, -9999, 20, 25, 26, 24],
]
export const NO_DATA = -9999

/** As the page holds them. */
export const KNOWN = HEIGHTS.flat().map((height) => (height === NO_DATA ? Number.NaN : height))

export const ASC = [
  'ncols 6',
  'nrows 5',
  'xllcorner 500000',
  'yllcorner 4200000',
  'cellsize 10',
  `NODATA_value ${NO_DATA}`,
  ...HEIGHTS.map((row) => row.join(' ')),
  '',
].join('\n')

/** Columns of 15 m, rows of 30 m. */
export const OBLONG_ASC = ASC.replace('cellsize 10', 'dx 15\ndy 30')

/** No format of heights alone has a word for no data. */
export const CSV = HEIGHTS.map((row) => row.map((height) => Math.max(0, height)).join(',')).join(
  '\n',
)

/** Little-endian, one strip of 32-bit floats, cells of 10 m. */
export function geotiff(): Buffer {
  const [width, height] = [6, 5]
  const heights = HEIGHTS.flat()
  const noData = `${NO_DATA}\0\0`
  // Header, 13 tags, then what does not fit into a tag.
  const after = 8 + 2 + 13 * 12 + 4
  const [scaleAt, tieAt, noDataAt] = [after, after + 24, after + 72]
  const dataAt = noDataAt + noData.length + (noData.length % 2)
  const file = Buffer.alloc(dataAt + 4 * heights.length)
  file.write('II*\0', 0, 'latin1')
  file.writeUInt32LE(8, 4)
  const tags: [id: number, type: number, count: number, value: number][] = [
    [256, 3, 1, width],
    [257, 3, 1, height],
    [258, 3, 1, 32],
    [259, 3, 1, 1],
    [262, 3, 1, 1],
    [273, 4, 1, dataAt],
    [277, 3, 1, 1],
    [278, 3, 1, height],
    [279, 4, 1, 4 * heights.length],
    [339, 3, 1, 3],
    [33550, 12, 3, scaleAt],
    [33922, 12, 6, tieAt],
    [42113, 2, noData.length, noDataAt],
  ]
  file.writeUInt16LE(tags.length, 8)
  for (const [i, [id, type, count, value]] of tags.entries()) {
    const at = 10 + 12 * i
    file.writeUInt16LE(id, at)
    file.writeUInt16LE(type, at + 2)
    file.writeUInt32LE(count, at + 4)
    if (type === 3) file.writeUInt16LE(value, at + 8)
    else file.writeUInt32LE(value, at + 8)
  }
  for (const [i, metres] of [10, 10, 0].entries()) file.writeDoubleLE(metres, scaleAt + 8 * i)
  for (const [i, value] of [0, 0, 0, 500000, 4200050, 0].entries())
    file.writeDoubleLE(value, tieAt + 8 * i)
  file.write(noData, noDataAt, 'latin1')
  for (const [i, value] of heights.entries()) file.writeFloatLE(value, dataAt + 4 * i)
  return file
}

/** 1201 × 1201 cells of three seconds of arc: a slope that rises to the south-east, with one cell missing. */
export function hgt(): Buffer {
  const file = Buffer.alloc(1201 * 1201 * 2)
  for (let y = 0; y < 1201; y++)
    for (let x = 0; x < 1201; x++) file.writeInt16BE(x + y, 2 * (1201 * y + x))
  file.writeInt16BE(-32768, 2 * (1201 * 600 + 600))
  return file
}
