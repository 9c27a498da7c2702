/** The formats in which a panel's path can be saved; those that cannot be had say why. */
import type { PathFormatFacts } from '@pkg/formicarium'
import { useEffect, useRef, useState } from 'preact/hooks'
import { describeError, describeNotice } from '../i18n/errors'
import { addPathsWords, t } from '../i18n/paths'
import { notify, notifyError, panelById, scenario } from '../state'
import { pathFormats, savePath } from '../state/path_files'
import { MenuHeading, MenuItem } from '../ui/menu'

/** With its words. */
export async function fetchPathItems(): Promise<typeof PathItems> {
  await addPathsWords()
  return PathItems
}

interface PathItemsProps {
  panelId: number
  /** Whether there is a path. */
  found: boolean
}

function PathItems({ panelId, found }: PathItemsProps) {
  const formats = useFormats()
  const list = useRef<HTMLDivElement>(null)
  // The menu was opened before it had anything to take the focus.
  useEffect(() => {
    if (list.current?.closest(':popover-open'))
      list.current.querySelector<HTMLElement>('.menu-item')?.focus()
  }, [formats.length])
  return (
    <div ref={list} role="presentation">
      <MenuHeading text={t('paths.saveAs')} />
      {formats.map((facts) => (
        <MenuItem
          key={facts.format}
          label={t(`paths.formats.${facts.format}.name`)}
          note={t(`paths.formats.${facts.format}.note`)}
          unavailable={found ? refused(facts) : t('paths.none')}
          testId={`path-${facts.format}`}
          onClick={() => save(panelId, facts).catch(notifyError)}
        />
      ))}
    </div>
  )
}

/** The formats of the map on show; empty while the engine is asked. */
function useFormats(): PathFormatFacts[] {
  const [formats, setFormats] = useState<PathFormatFacts[]>([])
  const spec = scenario.value?.spec
  useEffect(() => {
    let current = true
    pathFormats().then((all) => current && setFormats(all), notifyError)
    return () => {
      current = false
    }
  }, [spec])
  return formats
}

function refused({ refusal }: PathFormatFacts): string | null {
  return refusal && describeError(refusal).message
}

async function save(panelId: number, facts: PathFormatFacts): Promise<void> {
  const panel = panelById(panelId)
  if (!panel) return
  for (const notice of await savePath(panel, facts)) notify('info', describeNotice(notice))
}
