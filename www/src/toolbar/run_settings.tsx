import { Dices } from 'lucide'
import { tools } from '../engine/tools'
import { t } from '../i18n'
import type { Sync } from '../model/session'
import { notifyError, seed, setSeed, sync } from '../state'
import { IconButton } from '../ui/buttons'
import { NumberField, Select } from '../ui/fields'

const SYNCS: Sync[] = ['moves', 'iterations', 'paths', 'time']

/** How the panels keep step. */
export function SyncField() {
  return (
    <Select
      label={t('run.sync')}
      class="sync-field"
      value={sync.value}
      testId="sync"
      note={t('run.sync')}
      options={SYNCS.map((value) => ({ value, label: t(`run.syncs.${value}`) }))}
      onChange={(value) => {
        sync.value = value
      }}
    />
  )
}

/** One seed for every panel. */
export function SeedField() {
  const draw = () => tools.proposeSeed().then(setSeed, notifyError)
  return (
    <span class="seed-field">
      <NumberField
        label={t('run.seed')}
        value={seed.value}
        min={0}
        max={0xffffffff}
        step={1}
        nearest
        testId="seed"
        onChange={setSeed}
      />
      <IconButton icon={Dices} label={t('run.newSeed')} testId="new-seed" onClick={draw} />
    </span>
  )
}
