/** The panel clients by panel id: made when first needed, gone when the panel is removed. */
import type { PanelReply } from '../model/messages'
import { PanelClient } from './panel_client'

const clients = new Map<number, PanelClient>()
let listener: (panelId: number, reply: PanelReply) => void = () => {}

/** Sets who hears every reply; done once, by the conductor. */
export function listen(to: (panelId: number, reply: PanelReply) => void): void {
  listener = to
}

/** The client of a panel; undefined while it has not been made. */
export function client(panelId: number): PanelClient | undefined {
  return clients.get(panelId)
}

/** The client of a panel, made if need be: its first load may come before or after it is on screen. */
export function ensure(panelId: number): PanelClient {
  const existing = clients.get(panelId)
  if (existing) return existing
  const made = new PanelClient((reply) => listener(panelId, reply))
  clients.set(panelId, made)
  return made
}

/** Puts the panel's canvas into `host`. */
export function attach(panelId: number, host: HTMLElement): PanelClient {
  const panel = ensure(panelId)
  panel.mount(host)
  return panel
}

export function detach(panelId: number): void {
  clients.get(panelId)?.terminate()
  clients.delete(panelId)
}
