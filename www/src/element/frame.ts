/** The frame of the element: requests go in by messages, answers and events come out. */
import {
  type Answer,
  type RequestKind,
  type Requests,
  type Sent,
  VERSION,
} from '../model/embed_messages'
import { ScriptError } from '../model/script_error'

interface Given {
  address: string
  title: string
  tell(event: string, detail: unknown): void
  /** Opens what the address does not carry, once the frame takes requests. */
  open(frame: Frame): Promise<void> | null
}

interface Waiting {
  resolve(value: never): void
  reject(error: ScriptError): void
}

export class Frame {
  readonly element = document.createElement('iframe')
  /** The frame takes requests, and has opened what it was to open. */
  readonly opened: Promise<void>

  private readonly waiting = new Map<number, Waiting>()
  private readonly origin: string
  private asked = 0
  private isReady: () => void = () => {}
  private isGone: (why: ScriptError) => void = () => {}
  private gone: ScriptError | null = null

  constructor(private readonly given: Given) {
    this.origin = new URL(given.address).origin
    this.element.src = given.address
    this.element.title = given.title
    this.element.allow = 'clipboard-write'
    const ready = new Promise<void>((resolve, reject) => {
      this.isReady = resolve
      this.isGone = reject
    })
    this.opened = ready.then(() => given.open(this) ?? undefined)
    // Who waits for it hears of it.
    this.opened.catch(() => {})
    addEventListener('message', this.hear)
  }

  ask<K extends RequestKind>(kind: K, fields: Requests[K]): Promise<Answer<K>> {
    return new Promise((resolve, reject) => {
      if (this.gone) return reject(this.gone)
      const id = ++this.asked
      this.waiting.set(id, { resolve, reject })
      // A page without an origin cannot be addressed by it.
      const to = this.origin === 'null' ? '*' : this.origin
      const message = { formicarium: VERSION, kind, id, ...fields }
      this.element.contentWindow?.postMessage(message, to)
    })
  }

  /** What still waits for an answer will get none. */
  close(): void {
    removeEventListener('message', this.hear)
    this.element.remove()
    const hint = 'Ask the new frame.'
    const gone = new ScriptError('frame-left', '', 'the frame was closed or built anew', hint)
    this.gone = gone
    this.isGone(gone)
    for (const { reject } of this.waiting.values()) reject(gone)
    this.waiting.clear()
  }

  private readonly hear = ({ source, origin, data }: MessageEvent): void => {
    if (source !== this.element.contentWindow || origin !== this.origin) return
    if (data?.formicarium !== VERSION) return
    const sent = data as Sent
    if (sent.kind === 'event') {
      const { formicarium: _, kind: __, event, ...detail } = sent
      if (event === 'ready') this.isReady()
      this.given.tell(event, detail)
    } else if (typeof sent.id === 'number') this.settle(sent.id, sent)
  }

  private settle(id: number, sent: Exclude<Sent, { kind: 'event' }>): void {
    const waiting = this.waiting.get(id)
    this.waiting.delete(id)
    if (sent.kind === 'answer') waiting?.resolve(sent.value as never)
    else {
      const { kind, field, message, hint } = sent.error
      waiting?.reject(new ScriptError(kind, field, message, hint))
    }
  }
}
