/** The page's one store: what components may read and every action they may call. */
export * from './appearance'
export * from './column'
export { editor, withEditor } from './editor'
export * from './files'
export * from './focus'
export * from './layer_scale'
export * from './lesson'
export { changeLevel } from './levels'
export { flushLive, historyOf, latest, onReply } from './live_reports'
export { comparing, inspected, leavePast, lookedAt, shownOf } from './looking'
export {
  announce,
  announcement,
  dismiss,
  goOn,
  hold,
  isOutdated,
  notify,
  notifyError,
  reloadPage,
  type Toast,
  toasts,
} from './notices'
export * from './offered_files'
export { objectives, referenceOf } from './optimum'
export { showView, view } from './page_view'
export {
  addPanel,
  baseSet,
  paramValue,
  removePanel,
  setParam,
  setPlanner,
  setPreset,
  setSeed,
  setValues,
} from './panels'
export { inRelief } from './relief'
export {
  isIdle,
  pause,
  play,
  reset,
  restart,
  runOn,
  runToEnd,
  stepIteration,
  stepMove,
  toggle,
} from './runs'
export * from './scenarios'
export { compact, narrow } from './screen'
export { currentSession, loadSession, openFragment, readied, startOver } from './sessions'
export { slotColour } from './slot_colours'
export { chooseSpeed } from './speed'
export { startPage } from './start_page'
export * from './store'
export { fetchWholeEngine, fetchWholeEngineUnasked } from './whole_engine'
