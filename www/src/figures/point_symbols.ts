/** Shapes of points, the same in plots and legends: corners about the origin, filling about the area of a circle of radius 1. */

type Corner = readonly [number, number]

const star = Array.from({ length: 10 }, (_, i): Corner => {
  const [radius, angle] = [i % 2 === 0 ? 1.55 : 0.7, (Math.PI * i) / 5 - Math.PI / 2]
  return [radius * Math.cos(angle), radius * Math.sin(angle)]
})

// biome-ignore format: one arm a line
const cross: Corner[] = [
  [-0.45, -1.3], [0.45, -1.3], [0.45, -0.45],
  [1.3, -0.45], [1.3, 0.45], [0.45, 0.45],
  [0.45, 1.3], [-0.45, 1.3], [-0.45, 0.45],
  [-1.3, 0.45], [-1.3, -0.45], [-0.45, -0.45],
]

const saltire = cross.map(([x, y]): Corner => [(x - y) * Math.SQRT1_2, (x + y) * Math.SQRT1_2])

const CORNERS = {
  square: [
    [-0.89, -0.89],
    [0.89, -0.89],
    [0.89, 0.89],
    [-0.89, 0.89],
  ],
  triangle: [
    [0, -1.45],
    [1.3, 0.85],
    [-1.3, 0.85],
  ],
  falling: [
    [0, 1.45],
    [1.3, -0.85],
    [-1.3, -0.85],
  ],
  diamond: [
    [0, -1.45],
    [1.15, 0],
    [0, 1.45],
    [-1.15, 0],
  ],
  cross,
  saltire,
  star,
} as const satisfies Record<string, readonly Corner[]>

export type SymbolName = 'circle' | keyof typeof CORNERS

/** Of entries, in the order in which they are given out. Diamonds are kept for published numbers. */
export const SYMBOLS = [
  'circle',
  'square',
  'triangle',
  'falling',
  'star',
  'saltire',
  'cross',
] as const satisfies SymbolName[]

export function symbolPath(name: SymbolName, radius: number): string {
  if (name === 'circle')
    return `M${radius} 0A${radius} ${radius} 0 1 1 ${-radius} 0A${radius} ${radius} 0 1 1 ${radius} 0Z`
  const corners: readonly Corner[] = CORNERS[name]
  return `M${corners.map(([x, y]) => `${x * radius} ${y * radius}`).join('L')}Z`
}

/** What the plotting library draws with. `size`: area in square pixels. */
export function plotSymbol(name: SymbolName) {
  return {
    draw(context: CanvasPath, size: number): void {
      const radius = Math.sqrt(size / Math.PI)
      if (name === 'circle') {
        context.moveTo(radius, 0)
        context.arc(0, 0, radius, 0, 2 * Math.PI)
        return
      }
      const corners: readonly Corner[] = CORNERS[name]
      corners.forEach(([x, y], i) => {
        if (i === 0) context.moveTo(x * radius, y * radius)
        else context.lineTo(x * radius, y * radius)
      })
      context.closePath()
    },
  }
}
