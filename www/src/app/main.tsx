import '../engine/early'
import '../styles/index.css'
import './lazy_parts'
import { render } from 'preact'
import { startLanguage } from '../i18n'
import { anotherTask } from '../model/another_task'
import { notifyError, rememberedLanguage, startPage } from '../state'
import { embedding } from '../state/embedding'
import { App, drawRest } from './app'
import { listenForDrops } from './drop_files'
import { listenForPaste } from './paste'
import { offerScripting } from './scripting'
import { listenForKeys } from './shortcuts'
import { whenAntsWalk, whenAtRest } from './when_ants_walk'

/** What comes sooner is not announced. */
const SOON_MS = 400

async function main(): Promise<void> {
  await startLanguage(embedding ? embedding.get('lang') : rememberedLanguage())
  offerScripting()
  if (embedding) return (await import('./embed')).startEmbedded(embedding)
  listenForKeys()
  listenForPaste()
  listenForDrops()
  whenAntsWalk(() => setTimeout(announce, SOON_MS))
  whenAtRest(() => import('../offline').then(({ startResting }) => startResting()))
  const started = startPage()
  const soon = new Promise((resolve) => setTimeout(resolve, SOON_MS))
  await Promise.race([started.catch(() => {}), soon])
  await anotherTask()
  const root = document.getElementById('app')
  if (root) render(<App />, root)
  await anotherTask()
  drawRest()
  await started
}

const announce = () =>
  import('../panels/announce_run').then(({ announceRuns }) => announceRuns(), notifyError)

void main()
