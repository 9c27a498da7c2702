/** What specs know of the page's workers: what they were asked for and have answered, and when what they draw is on the screen. */
import type { Page } from '@playwright/test'

declare global {
  interface Window {
    /** How often workers were asked for what, and how often they have answered. */
    asked: Record<string, number>
    answered: Record<string, number>
  }
}

/** Counts from the page's next opening on. */
export async function countCalls(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.asked = {}
    window.answered = {}
    const count = (counts: Record<string, number>, what: string) => {
      counts[what] = (counts[what] ?? 0) + 1
    }
    const post = Worker.prototype.postMessage
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
      const { kind, call, id } = message as { kind: string; call?: string; id?: number }
      count(window.asked, call ?? kind)
      if (call)
        this.addEventListener('message', ({ data }) => {
          if (data.id === id) count(window.answered, call)
        })
      Reflect.apply(post, this, [message, ...rest])
    }
  })
}

/** A run moves by ticks alone: as long as none is asked for, it rests. */
export const ticks = (page: Page) => page.evaluate(() => window.asked.tick ?? 0)

/** Resolves when all that the page has told its workers so far is on the screen: they draw in frames of their own. */
export async function drawn(page: Page): Promise<void> {
  const frames = () =>
    new Promise<void>((resolve) => {
      requestAnimationFrame(() => requestAnimationFrame(() => resolve()))
    })
  await page.evaluate(frames)
  // One that is ended meanwhile draws nothing.
  await Promise.all(page.workers().map((worker) => worker.evaluate(frames).catch(() => {})))
  await page.evaluate(frames)
}
