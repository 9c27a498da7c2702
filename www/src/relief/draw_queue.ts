/** Pictures are drawn on demand: one drawing of each panel in a frame, as many panels as fit into it, the others in the next. */
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
