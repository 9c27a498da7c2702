/** Numbers of a map's cells, heights or factors, as the engine hands them over: little-endian f32, one a cell; nothing where it has none. */
export function numbersOf(bytes: Uint8Array): Float32Array | null {
  if (bytes.length === 0) return null
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true))
}
