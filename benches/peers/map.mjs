/** A map as `formicarium` writes it: JSON whose `map.rows` are rows of `.` and `@`. */
export function parse(text) {
  const { map, ...spec } = JSON.parse(text)
  const cells = Uint8Array.from(map.rows.join(''), (sign) => (sign === '@' ? 1 : 0))
  return { spec, cells }
}
