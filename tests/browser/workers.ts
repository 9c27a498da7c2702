/** The page's workers as specs see them: what they were asked, what they answered, and when their drawings are on screen. */
import type { Page } from '@playwright/test'

declare global {
  interface Window {
    /** How often workers were asked, by kind, and how often they answered. */
    asked: Record<string, number>
    answered: Record<string, number>
  }
}

/** Counts from the next time the page is opened. */
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

/** Runs move by ticks only: without a tick they stand still. */
export const ticks = (page: Page) => page.evaluate(() => window.asked.tick ?? 0)

/** Resolves when workers have drawn all they have been told so far; they draw in frames of their own. */
export async function drawn(page: Page): Promise<void> {
  const frames = () =>
    new Promise<void>((resolve) => {
      requestAnimationFrame(() => requestAnimationFrame(() => resolve()))
    })
  await page.evaluate(frames)
  // A worker that has been ended draws nothing.
  await Promise.all(page.workers().map((worker) => worker.evaluate(frames).catch(() => {})))
  await page.evaluate(frames)
}
