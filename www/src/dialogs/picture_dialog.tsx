/** Takes the map, the convergence or the profile away as a picture: what is chosen is seen before it is saved. */
import '../styles/picture.css'
import { Clapperboard, FileCode2, Image } from 'lucide'
import { useEffect, useRef, useState } from 'preact/hooks'
import {
  pictureKinds,
  pictureOf,
  picturesReady,
  savePngOf,
  saveSvg,
  type Wanted,
} from '../figures/pictures'
import { addFilmWords, t as filmWords } from '../i18n/film'
import { t } from '../i18n/pictures'
import { notifyError, panels, selectedPanel } from '../state'
import { closeDialog, show } from '../state/dialogs'
import { type PictureKind, wantedPicture } from '../state/pictures'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { Segmented, Select } from '../ui/fields'
import { lazily } from '../ui/lazily'
import { panelTitle } from '../words/planner_words'
import type { Corner } from './picture_corner'

/** Once its words are here. */
export const PictureDialog = lazily(async () => {
  await Promise.all([picturesReady(), addFilmWords()])
  return Shown
})

const CornerChoice = lazily(async () => (await import('./picture_corner')).CornerChoice)

const SCALES = [2, 3] as const
const GROUNDS = ['page', 'print'] as const

function Shown() {
  const [wanted, setWanted] = useState<Wanted>({
    kind: wantedPicture.peek(),
    whose: selectedPanel.value ?? panels.value[0]?.id ?? 'all',
    ground: 'page',
  })
  const [corner, setCorner] = useState<Corner | null>(null)
  const svg = usePicture(wanted, corner)
  const change = (part: Partial<Wanted>) => setWanted({ ...wanted, ...part })
  return (
    <Dialog
      title={t('pictures.title')}
      onClose={closeDialog}
      testId="picture-dialog"
      wide
      actions={<Actions svg={svg} kind={wanted.kind} />}
    >
      <div class="picture-choices">
        <Segmented
          label={t('pictures.kind')}
          value={wanted.kind}
          options={pictureKinds().map((value) => ({
            value,
            label: t(`pictures.kinds.${value}`),
            testId: `picture-${value}`,
          }))}
          onChange={(kind) => change({ kind })}
        />
        {wanted.kind === 'map' && <WhoseField whose={wanted.whose} onChange={change} />}
        <Segmented
          label={t('pictures.ground')}
          value={wanted.ground}
          options={GROUNDS.map((value) => ({
            value,
            label: t(`pictures.grounds.${value}`),
            testId: `picture-${value}`,
          }))}
          onChange={(ground) => change({ ground })}
        />
        <CornerChoice corner={corner} onChange={setCorner} />
      </div>
      <Preview svg={svg} />
    </Dialog>
  )
}

interface WhoseFieldProps {
  whose: Wanted['whose']
  onChange: (part: Pick<Wanted, 'whose'>) => void
}

function WhoseField({ whose, onChange }: WhoseFieldProps) {
  const all = panels.value.map(({ id }) => ({
    value: String(id),
    label: t('pictures.one', { planner: panelTitle(id) }),
  }))
  return (
    <Select
      label={t('pictures.whose')}
      value={String(whose)}
      testId="picture-whose"
      options={[{ value: 'all', label: t('pictures.all') }, ...all]}
      onChange={(value) => onChange({ whose: value === 'all' ? 'all' : Number(value) })}
    />
  )
}

/** Undefined while it is being drawn; null where there is nothing to draw. */
type Made = SVGSVGElement | null | undefined

function usePicture({ kind, whose, ground }: Wanted, corner: Corner | null): Made {
  const [made, setMade] = useState<{ key: string; svg: SVGSVGElement | null } | null>(null)
  const key = `${kind} ${whose} ${ground} ${corner?.text}`
  useEffect(() => {
    let current = true
    pictureOf({ kind, whose, ground }).then(
      (svg) => current && setMade({ key, svg: svg && corner ? corner.add(svg) : svg }),
      (error) => {
        if (!current) return
        setMade({ key, svg: null })
        notifyError(error)
      },
    )
    return () => {
      current = false
    }
  }, [key])
  return made?.key === key ? made.svg : undefined
}

function Preview({ svg }: { svg: Made }) {
  const host = useRef<HTMLDivElement>(null)
  useEffect(() => host.current?.replaceChildren(...(svg ? [svg] : [])), [svg])
  return (
    <>
      {svg === null && (
        <p class="hint" role="status" data-testid="picture-nothing">
          {t('pictures.nothing')}
        </p>
      )}
      {svg === undefined && (
        <p class="hint" role="status">
          {t('common.working')}
        </p>
      )}
      <section
        ref={host}
        class="picture-preview"
        aria-label={t('pictures.preview')}
        data-testid="picture-preview"
        data-ready={Boolean(svg)}
      />
    </>
  )
}

function Actions({ svg, kind }: { svg: Made; kind: PictureKind }) {
  return (
    <>
      <Button
        icon={Clapperboard}
        label={filmWords('film.open')}
        tone="quiet"
        testId="picture-film"
        onClick={() => show('film')}
      />
      {SCALES.map((scale) => (
        <Button
          key={scale}
          icon={Image}
          label={t('pictures.png', { scale })}
          testId={`picture-png-${scale}`}
          disabled={!svg}
          onClick={() => {
            if (svg) savePngOf(svg, kind, scale).catch(notifyError)
          }}
        />
      ))}
      <Button
        icon={FileCode2}
        label={t('pictures.svg')}
        tone="primary"
        testId="picture-svg"
        disabled={!svg}
        onClick={() => {
          if (svg) saveSvg(svg, kind)
        }}
      />
    </>
  )
}
