/** The code of the race's link in the corner of a picture: made when it is first wanted. */
import { useState } from 'preact/hooks'
import { withCode } from '../figures/qr_code'
import { codeWords } from '../film/captions'
import { linkOfRace } from '../film/link_of_race'
import { t } from '../i18n/film'
import { notifyError } from '../state'

export interface Corner {
  /** The link. */
  text: string
  add(svg: SVGSVGElement): SVGSVGElement
}

interface CornerChoiceProps {
  corner: Corner | null
  onChange: (corner: Corner | null) => void
}

export function CornerChoice({ corner, onChange }: CornerChoiceProps) {
  const [without, setWithout] = useState(false)
  const change = async (wanted: boolean) => {
    if (!wanted) return onChange(null)
    const found = await linkOfRace()
    const { code } = found
    setWithout(code === null)
    onChange(code && { text: code.text, add: (svg) => withCode(svg, code, codeWords(found)) })
  }
  return (
    <label class="picture-code">
      <input
        type="checkbox"
        data-testid="picture-code"
        checked={corner !== null}
        disabled={without}
        onChange={(event) => change(event.currentTarget.checked).catch(notifyError)}
      />
      {t(without ? 'qr.none' : 'qr.add')}
    </label>
  )
}
