/** The page's one store: what components may read and every action they may call. */
export * from './state/appearance'
export { slotColour } from './state/colours'
export * from './state/files'
export { flushLive, historyOf, latest, onReply } from './state/live'
export { comparing, inspected, leavePast, lookedAt, shownOf } from './state/looking'
export {
  announce,
  announcement,
  dismiss,
  notify,
  notifyError,
  type Toast,
  toasts,
} from './state/notices'
export { objectives, referenceOf } from './state/optimum'
export {
  addPanel,
  paramValue,
  removePanel,
  setParam,
  setPlanner,
  setPreset,
  setSeed,
} from './state/panels'
export { fetchRest, fetchUnasked } from './state/rest'
export { changeLevel, type Rules, setRules } from './state/rules'
export {
  pause,
  play,
  reset,
  restart,
  runToEnd,
  stepIteration,
  stepMove,
  toggle,
} from './state/runs'
export * from './state/scenarios'
export { currentSession, loadSession, openFragment, startOver } from './state/sessions'
export { chooseSpeed } from './state/speed'
export { startPage } from './state/start'
export * from './state/store'
export { type TerrainFile, terrainFile } from './state/terrain_files'
export { showView, view } from './state/view'
