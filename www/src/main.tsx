import './styles/index.css'
import { render } from 'preact'
import { App } from './app'
import { listenForKeys } from './help/shortcuts'
import { startLanguage } from './i18n'
import { listenForDrops } from './maps/drop'
import { listenForPaste } from './maps/paste'
import { announceResults } from './panels/announce_result'
import { offerScripting } from './scripting'
import { startPage } from './state'

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
