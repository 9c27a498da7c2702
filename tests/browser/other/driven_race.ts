/** The race in a browser beside Chromium. */
import { expect } from '@playwright/test'
import { Race, runsAreLoaded } from '../race'

export abstract class DrivenRace extends Race {
  constructor(private readonly site: string) {
    super()
  }

  /** Leads the window to an address and waits for its page. */
  abstract go(address: string): Promise<void>

  async open(address = './'): Promise<void> {
    await this.go('about:blank')
    await this.go(new URL(address, this.site).href)
    await this.ready()
  }

  async ready(): Promise<void> {
    await expect.poll(() => this.ask(runsAreLoaded)).toBe(true)
  }
}
