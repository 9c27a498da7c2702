import '../styles/index.css'
import './lazy_parts'
import { render } from 'preact'
import { startLanguage } from '../i18n'
import { announceResults } from '../panels/announce_result'
import { startPage } from '../state'
import { App } from './app'
import { listenForDrops } from './drop_files'
import { listenForPaste } from './paste'
import { offerScripting } from './scripting'
import { listenForKeys } from './shortcuts'

async function main(): Promise<void> {
  await startLanguage()
  const root = document.getElementById('app')
  if (root) render(<App />, root)
  listenForKeys()
  listenForPaste()
  listenForDrops()
  offerScripting()
  announceResults()
  await startPage()
}

void main()
