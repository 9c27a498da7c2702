/** How the maps are looked at: what lies under ants and paths, and how near. */
import { Bug, Equal, Maximize, Route, ZoomIn, ZoomOut } from 'lucide'
import { t } from '../i18n'
import { layerChoices } from '../model/session'
import {
  layer,
  panels,
  plannerEntry,
  sameScale,
  setSameScale,
  showAnts,
  showPath,
  wholeEngine,
} from '../state'
import { fitWholeMap, onTerrain, zoomView } from '../state/relief'
import { IconButton } from '../ui/buttons'
import { Select } from '../ui/fields'
import { lazily } from '../ui/lazily'

const ReliefControls = lazily(
  async () => (await import('../relief/relief_controls')).ReliefControls,
)

const CompareButton = lazily(async () => (await import('../playback')).fetchCompareButton())

const LAYERS = layerChoices()

export function ViewControls() {
  const offered = new Set(
    panels.value.flatMap(({ setup }) => plannerEntry(setup.planner)?.layers ?? []),
  )
  return (
    <div class="view-controls" role="toolbar" aria-label={t('view.group')}>
      <Select
        label={t('view.layer')}
        value={layer.value}
        testId="layer"
        note={layer.value === 'none' ? undefined : t(`view.layerNotes.${layer.value}`)}
        options={LAYERS.filter((id) => id === layer.value || id === 'none' || offered.has(id)).map(
          (id) => ({
            value: id,
            label: t(`view.layers.${id}`),
            note: id === 'none' ? undefined : t(`view.layerNotes.${id}`),
          }),
        )}
        onChange={(id) => {
          layer.value = id
        }}
      />
      {panels.value.length > 1 && (
        <IconButton
          icon={Equal}
          label={t('view.sameScale')}
          pressed={sameScale.value}
          testId="same-scale"
          onClick={() => setSameScale(!sameScale.value)}
        />
      )}
      <IconButton
        icon={Bug}
        label={t('view.ants')}
        pressed={showAnts.value}
        testId="show-ants"
        onClick={() => {
          showAnts.value = !showAnts.value
        }}
      />
      <IconButton
        icon={Route}
        label={t('view.path')}
        pressed={showPath.value}
        testId="show-path"
        onClick={() => {
          showPath.value = !showPath.value
        }}
      />
      {panels.value.length > 1 && wholeEngine.value === 'here' && <CompareButton />}
      {onTerrain.value && <ReliefControls />}
      <span class="divider" />
      <IconButton icon={ZoomOut} label={t('view.out')} onClick={() => zoomView(1 / 1.4)} />
      <IconButton
        icon={Maximize}
        label={t('view.fit')}
        keys="0"
        testId="fit"
        onClick={fitWholeMap}
      />
      <IconButton icon={ZoomIn} label={t('view.in')} onClick={() => zoomView(1.4)} />
    </div>
  )
}
