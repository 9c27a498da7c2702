/** Panels are drawn on demand: at most once a frame each, and those that do not fit into a frame in the next. */
const BUDGET_MS = 12

const waiting = new Set<() => void>()
let requested = 0

export function drawSoon(draw: () => void): void {
  waiting.add(draw)
  if (requested === 0) requested = requestAnimationFrame(drawNow)
}

export function cancelDraw(draw: () => void): void {
  waiting.delete(draw)
}

function drawNow(): void {
  requested = 0
  const until = performance.now() + BUDGET_MS
  for (const draw of [...waiting]) {
    waiting.delete(draw)
    draw()
    if (performance.now() > until) break
  }
  if (waiting.size > 0) requested = requestAnimationFrame(drawNow)
}
