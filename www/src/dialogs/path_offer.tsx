/** A planner's path as a file, in "Export": narrow heads of panels have no room for it. */
import type { PathFormat, PathFormatFacts } from '@pkg/formicarium'
import { Download } from 'lucide'
import { useEffect, useState } from 'preact/hooks'
import { describeError, describeNotice } from '../i18n/errors'
import { addPathsWords, t } from '../i18n/paths'
import { notify, notifyError, type Panel, panels, shownOf } from '../state'
import { pathFormats, savePath } from '../state/path_files'
import { Button } from '../ui/buttons'
import { Select } from '../ui/fields'
import { panelTitle } from '../words/planner_words'

/** With its words, and the formats of the map on show. */
export async function fetchPathOffer() {
  await addPathsWords()
  return PathOffer
}

function PathOffer() {
  const formats = useFormats()
  const [chosen, setChosen] = useState<PathFormat | null>(null)
  const [whose, setWhose] = useState<number | null>(null)
  const found = panels.value.filter((panel) => shownOf(panel).bestPath?.length)
  const panel = found.find(({ id }) => id === whose) ?? found[0]
  const format = formats.find((facts) => facts.format === chosen) ?? formats[0]
  return (
    <fieldset class="rule-group" data-testid="path-offer">
      <legend>{t('paths.title')}</legend>
      {panel && format ? (
        <>
          <div class="field-row">
            <Select
              label={t('paths.whose')}
              value={String(panel.id)}
              testId="path-of"
              options={found.map(({ id }) => ({ value: String(id), label: panelTitle(id) }))}
              onChange={(id) => setWhose(Number(id))}
            />
            <Select
              label={t('paths.as')}
              value={format.format}
              testId="path-as"
              options={formats.map((each) => ({
                value: each.format,
                label: t(`paths.formats.${each.format}.name`),
              }))}
              onChange={setChosen}
            />
            <Button
              icon={Download}
              label={t('paths.save')}
              testId="path-save"
              disabled={format.refusal !== null}
              onClick={() => save(panel, format).catch(notifyError)}
            />
          </div>
          <p class="hint">
            {format.refusal
              ? describeError(format.refusal).message
              : t(`paths.formats.${format.format}.note`)}
          </p>
        </>
      ) : (
        <p class="hint">{found.length === 0 && t('paths.none')}</p>
      )}
    </fieldset>
  )
}

/** Empty while the engine is asked. */
function useFormats(): PathFormatFacts[] {
  const [formats, setFormats] = useState<PathFormatFacts[]>([])
  useEffect(() => {
    pathFormats().then(setFormats, notifyError)
  }, [])
  return formats
}

async function save(panel: Panel, facts: PathFormatFacts): Promise<void> {
  for (const notice of await savePath(panel, facts)) notify('info', describeNotice(notice))
}
