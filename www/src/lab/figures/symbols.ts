/** Shapes of points, the same in plots and legends: corners about the origin, filling about the area of a circle of radius 1. */

type Corner = readonly [number, number]

const star = Array.from({ length: 10 }, (_, i): Corner => {
  const [radius, angle] = [i % 2 === 0 ? 1.55 : 0.7, (Math.PI * i) / 5 - Math.PI / 2]
  return [radius * Math.cos(angle), radius * Math.sin(angle)]
})

const hexagon = Array.from({ length: 6 }, (_, i): Corner => {
  const angle = (Math.PI * i) / 3
  return [1.1 * Math.cos(angle), 1.1 * Math.sin(angle)]
})

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
  // biome-ignore format: one arm a line
  cross: [
    [-0.45, -1.3], [0.45, -1.3], [0.45, -0.45],
    [1.3, -0.45], [1.3, 0.45], [0.45, 0.45],
    [0.45, 1.3], [-0.45, 1.3], [-0.45, 0.45],
    [-1.3, 0.45], [-1.3, -0.45], [-0.45, -0.45],
  ],
  hexagon,
  star,
} as const satisfies Record<string, readonly Corner[]>

export type SymbolName = 'circle' | keyof typeof CORNERS

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
