/**
 * `<formicarium-race src="…">`: Formicarium in a frame, for pages of any kind. It shows the embedded page and speaks its messages;
 * docs/embedding.md describes both.
 */
import type { ReportLanguage, ResultFile } from '@pkg/formicarium'
import type { EventName, Events } from '../model/embed_messages'
import { CONTROLS, type Control, embeddedAddress } from '../model/embedding'
import { ScriptError, toScriptError } from '../model/script_error'
import type {
  CompareOptions,
  ComparisonResult,
  LoadOptions,
  Opened,
  PanelResult,
  RunOptions,
  Source,
} from '../model/scripting'
import type { Session } from '../model/session'
import { Frame } from './frame'

export type {
  CompareOptions,
  ComparisonResult,
  Control,
  Events,
  LoadOptions,
  Opened,
  PanelResult,
  RunOptions,
  ScriptError,
  Session,
  Source,
}

/** The package's own page, if it brings one: the build says so. */
declare const OWN_PAGE: string | null

/** What the element tells, by the name of the event. */
export type RaceEvents = { [E in EventName]: CustomEvent<Events[E]> } & {
  /** What `src` was refused for. */
  error: CustomEvent<ScriptError>
}

const SHEET =
  ':host { display: block; width: 100%; height: 480px } iframe { width: 100%; height: 100%; border: 0 }'

/** Where there is no document, the module can be imported all the same. */
const Base: typeof HTMLElement = globalThis.HTMLElement ?? class {}

export class FormicariumRace extends Base {
  static readonly observedAttributes = ['src', 'page', 'controls', 'theme', 'lang', 'autoplay']

  #frame: Frame | null = null
  #isDue = false

  override addEventListener<E extends keyof RaceEvents>(
    type: E,
    listener: (this: FormicariumRace, event: RaceEvents[E]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void
  override addEventListener(
    type: string,
    listener: unknown,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener as EventListener, options)
  }

  connectedCallback(): void {
    if (!this.shadowRoot) {
      const sheet = new CSSStyleSheet()
      sheet.replaceSync(SHEET)
      this.attachShadow({ mode: 'open' }).adoptedStyleSheets = [sheet]
    }
    this.#build()
  }

  disconnectedCallback(): void {
    this.#frame?.close()
    this.#frame = null
  }

  attributeChangedCallback(_: string, before: string | null, now: string | null): void {
    if (before === now || !this.shadowRoot || this.#isDue) return
    this.#isDue = true
    // Several attributes are often set one after the other.
    queueMicrotask(() => {
      this.#isDue = false
      if (this.isConnected) this.#build()
    })
  }

  /** Resolves once the frame takes requests and `src` has been opened, or refused. */
  get ready(): Promise<void> {
    return this.#now().then((frame) => frame.opened)
  }

  /** Opens a link, the text of any file that can be read, a session, a file, or files that belong together. */
  async load(source: Source, options?: LoadOptions): Promise<Opened> {
    return (await this.#atRest()).ask('load', { source, options })
  }

  /** Runs every panel to its end, for a number of iterations, or to a stop, and gives the results. */
  async run(options?: RunOptions): Promise<PanelResult[]> {
    return (await this.#atRest()).ask('run', { options })
  }

  async pause(): Promise<void> {
    await (await this.#atRest()).ask('pause', {})
  }

  /** Looks back at an iteration in every panel; null returns to the present. */
  async look(iteration: number | null): Promise<PanelResult[]> {
    return (await this.#atRest()).ask('look', { iteration })
  }

  async results(): Promise<PanelResult[]> {
    return (await this.#atRest()).ask('results', {})
  }

  async session(): Promise<Session | null> {
    return (await this.#atRest()).ask('session', {})
  }

  /** The version of the engine in the frame. */
  async version(): Promise<string> {
    return (await this.#atRest()).ask('version', {})
  }

  /** Runs planners on maps with many seeds, or any comparison that a document holds. */
  async compare(options?: CompareOptions): Promise<ComparisonResult> {
    return (await this.#atRest()).ask('compare', { options })
  }

  /** A result file of the comparison that is open, as text. */
  async resultFile(file: ResultFile, language?: ReportLanguage): Promise<string> {
    return (await this.#atRest()).ask('resultFile', { file, language })
  }

  async #now(): Promise<Frame> {
    // An attribute that was set before has its effect first.
    await null
    if (this.#frame) return this.#frame
    const hint = 'Put it into the document first, with a page.'
    throw new ScriptError('no-frame', '', 'the element has no frame', hint)
  }

  async #atRest(): Promise<Frame> {
    const frame = await this.#now()
    await frame.opened
    return frame
  }

  #build(): void {
    this.#frame?.close()
    this.#frame = null
    const page = this.getAttribute('page') ?? OWN_PAGE
    if (page === null) {
      const hint = 'Set it to the address at which Formicarium is.'
      this.#tell('error', new ScriptError('no-page', 'page', 'page is not set', hint))
      return
    }
    const src = this.getAttribute('src') ?? ''
    const [, fragment = ''] = /(#[xq]=\S+)/.exec(src) ?? []
    const address = new URL(page, document.baseURI).href
    const frame = new Frame({
      address: embeddedAddress(address, this.#asked(), fragment),
      title: this.getAttribute('title') ?? 'Formicarium',
      tell: (event, detail) => this.#tell(event, detail),
      open: (frame) => (fragment === '' && src !== '' ? this.#open(frame, src) : null),
    })
    this.#frame = frame
    this.shadowRoot?.replaceChildren(frame.element)
  }

  #asked() {
    return {
      controls: this.#controls(),
      theme: this.getAttribute('theme'),
      lang: this.getAttribute('lang'),
      autoplay: this.hasAttribute('autoplay'),
      origin: window.origin,
    }
  }

  /** Those that are not known go along: the frame says so. */
  #controls(): Control[] {
    const names = (this.getAttribute('controls') ?? '').split(/[\s,]+/).filter(Boolean) as Control[]
    return names.toSorted((a, b) => CONTROLS.indexOf(a) - CONTROLS.indexOf(b))
  }

  /** The text of a session or map, or the address of one. */
  async #open(frame: Frame, src: string): Promise<void> {
    try {
      const isText = /[\n{]/.test(src)
      await frame.ask('load', { source: isText ? src : await fetched(src) })
    } catch (error) {
      this.#tell('error', toScriptError(error))
    }
  }

  #tell(event: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(event, { detail }))
  }
}

async function fetched(src: string): Promise<File> {
  const address = new URL(src, document.baseURI)
  const response = await fetch(address)
  if (!response.ok) {
    const hint = 'Look whether the file is there.'
    throw new ScriptError('not-fetched', 'src', `${address} answers ${response.status}`, hint)
  }
  return new File([await response.blob()], address.pathname.split('/').at(-1) ?? 'file')
}

declare global {
  interface HTMLElementTagNameMap {
    'formicarium-race': FormicariumRace
  }
}

globalThis.customElements?.define('formicarium-race', FormicariumRace)
