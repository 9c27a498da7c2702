/** The link of the share dialog as a QR code, small and on the whole screen; and the way to films of the race. */
import '../styles/link_code.css'
import { Clapperboard, FileCode2, X } from 'lucide'
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks'
import { MOST_QR_BYTES, type QrCode, qrCode, qrSvg } from '../figures/qr_code'
import { svgText } from '../figures/svg'
import { numbers } from '../i18n'
import { t } from '../i18n/film'
import { notifyError } from '../state'
import { show } from '../state/dialogs'
import { download, fileStem } from '../state/export_files'
import { Button } from '../ui/buttons'
import { Icon } from '../ui/icon'

/** Pixels of a code before it is scaled, and of its file. */
const SIDE = 1024

/** `link`: null until it is there. */
export function LinkCode({ link }: { link: string | null }) {
  return (
    <details
      class="link-code"
      onToggle={({ currentTarget }) => currentTarget.open && currentTarget.scrollIntoView()}
    >
      <summary data-testid="link-code">{t('qr.title')}</summary>
      <Body link={link} />
    </details>
  )
}

export const FilmButton = () => (
  <div class="share-film">
    <Button
      icon={Clapperboard}
      label={t('film.open')}
      tone="quiet"
      testId="share-film"
      onClick={() => show('film')}
    />
  </div>
)

function Body({ link }: { link: string | null }) {
  const code = useCode(link)
  const [large, setLarge] = useState(false)
  if (link === null || code === undefined) return <p class="hint">{t('common.working')}</p>
  if (code === null) {
    const { whole } = numbers.value
    const bytes = whole.format(new TextEncoder().encode(link).length)
    return (
      <p class="banner" data-testid="link-code-too-long">
        {t('qr.tooLong', { bytes, most: whole.format(MOST_QR_BYTES) })}
      </p>
    )
  }
  return (
    <div class="link-code-body">
      <button
        type="button"
        class="link-code-small"
        aria-label={t('qr.large')}
        data-testid="link-code-large"
        onClick={() => setLarge(true)}
      >
        <Picture code={code} />
      </button>
      <div>
        <p class="hint">{t('qr.what')}</p>
        <p class="hint">{t('qr.size', { modules: code.modules })}</p>
        <Button
          icon={FileCode2}
          label={t('qr.save')}
          testId="link-code-save"
          onClick={() => save(code)}
        />
      </div>
      {large && <WholeScreen code={code} onClose={() => setLarge(false)} />}
    </div>
  )
}

/** Undefined while it is being made; null where the link is too long. */
function useCode(link: string | null): QrCode | null | undefined {
  const [made, setMade] = useState<{ link: string; code: QrCode | null } | null>(null)
  useEffect(() => {
    let wanted = true
    if (link !== null) qrCode(link).then((code) => wanted && setMade({ link, code }), notifyError)
    return () => {
      wanted = false
    }
  }, [link])
  return made?.link === link ? made.code : undefined
}

const svgOf = (code: QrCode) => qrSvg(code, SIDE, t('qr.picture'))

const save = (code: QrCode) =>
  download(`${fileStem()}-qr.svg`, svgText(svgOf(code)), 'image/svg+xml')

function Picture({ code }: { code: QrCode }) {
  const host = useRef<HTMLSpanElement>(null)
  useEffect(() => host.current?.replaceChildren(svgOf(code)), [code])
  return <span ref={host} class="link-code-picture" data-modules={code.modules} />
}

/** White to the edges, as readers of codes want it; any press closes it. */
function WholeScreen({ code, onClose }: { code: QrCode; onClose: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => dialog.current?.showModal(), [])
  return (
    <dialog
      ref={dialog}
      class="link-code-screen"
      aria-label={t('qr.picture')}
      data-testid="link-code-screen"
      onClose={onClose}
    >
      <button type="button" aria-label={t('qr.close')} onClick={onClose}>
        <Picture code={code} />
        <Icon icon={X} />
      </button>
    </dialog>
  )
}
