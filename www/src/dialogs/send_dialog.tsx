/** A dialog that shares something as a link, a file, or a picture with it inside. */
import { Copy, FileDown, ImageDown } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useEffect, useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/dialogs'
import { LINK_LIMIT } from '../share/envelope'
import { LinkError } from '../share/link_error'
import { pageAddress } from '../share/page_file'
import { notifyError } from '../state'
import { Button } from '../ui/buttons'
import { copyText } from '../ui/copy_text'
import { Dialog } from '../ui/dialog'
import { lazily } from '../ui/lazily'
import { BareLinkHint, type PageContents, PageOffer } from './save_page'

const EmbedSnippet = lazily(async () => {
  const [{ EmbedSnippet }, { addEmbedWords }] = await Promise.all([
    import('./embed_snippet'),
    import('../i18n/embed'),
  ])
  await addEmbedWords()
  return EmbedSnippet
})

/** Stands for a link that cannot be made. */
const TOO_LARGE = 'too large'

/** An address, the mark that there can be none, or null while it is being made. */
export type Link = string | typeof TOO_LARGE | null

/**
 * An address made once, as runs may go on behind the dialog; made again when `about` is another, and null until then, so that nobody
 * copies what no longer holds. `make` is null while there is nothing to share.
 */
export function useLink(
  prefix: string,
  make: (() => Promise<string>) | null,
  about?: unknown,
): Link {
  const [made, setMade] = useState<{ link: Link; of: unknown } | null>(null)
  useEffect(() => {
    const page = pageAddress()
    let wanted = true
    const take = (link: Link) => {
      if (wanted) setMade({ link, of: about })
    }
    make?.().then(
      (text) => take(`${page}${prefix}${text}`),
      (error) => {
        if (error instanceof LinkError) take(TOO_LARGE)
        else notifyError(error)
      },
    )
    return () => {
      wanted = false
    }
  }, [about])
  return made?.of === about ? (made?.link ?? null) : null
}

/** Whether there is no link, or one so long that many programs would cut it. */
export const isTooLong = (link: Link) =>
  link === TOO_LARGE || (link !== null && link.length > LINK_LIMIT)

interface SendDialogProps {
  title: string
  /** What it is called that is shared. */
  name: string
  /** What its receiver gets. */
  what: string
  link: Link
  /** What to do instead of a link that is too long, or of one that cannot be made. */
  tooLong: (lengths: { length: string; limit: string }) => string
  tooLarge: string
  savePicture: () => Promise<void>
  saveFile: () => Promise<void>
  /** What a page of its own carries, as text, and what the page is called. */
  pageOf: () => Promise<PageContents>
  onClose: () => void
  /** Prefix of all test ids. */
  testId: string
  /** What the link holds, so that nothing is shared unseen. */
  children: ComponentChildren
}

export function SendDialog(props: SendDialogProps) {
  const { link, testId } = props
  const tooLong = isTooLong(link)
  return (
    <Dialog
      title={props.title}
      onClose={props.onClose}
      testId={`${testId}-dialog`}
      actions={
        <>
          <Button
            icon={ImageDown}
            label={t('share.picture')}
            testId={`${testId}-picture`}
            disabled={link === null}
            onClick={() => void props.savePicture().catch(notifyError)}
          />
          <Button
            icon={FileDown}
            label={t('share.file')}
            tone={tooLong ? 'primary' : 'plain'}
            testId={`${testId}-file`}
            onClick={() => void props.saveFile().catch(notifyError)}
          />
          {!tooLong && (
            <Button
              icon={Copy}
              label={t('share.copy')}
              tone="primary"
              testId={`${testId}-copy`}
              disabled={link === null}
              onClick={() => copyText(link ?? '')}
            />
          )}
        </>
      }
    >
      <p>{props.what}</p>
      {props.children}
      {tooLong ? (
        <p class="banner" data-testid={`${testId}-too-long`}>
          {link === TOO_LARGE ? props.tooLarge : props.tooLong(lengths(link))}
        </p>
      ) : (
        <>
          <input
            class="input share-link"
            readOnly
            value={link ?? t('common.working')}
            aria-label={t('share.link')}
            data-testid={`${testId}-link`}
            onFocus={(event) => event.currentTarget.select()}
          />
          <p class="hint">{t('share.private', { length: lengths(link).length })}</p>
          <BareLinkHint />
        </>
      )}
      <PageOffer contents={props.pageOf} testId={testId} />
      {link !== null && link !== TOO_LARGE && (
        <EmbedSnippet link={link} name={props.name} isRace={testId === 'share'} />
      )}
    </Dialog>
  )
}

function lengths(link: Link): { length: string; limit: string } {
  const { whole } = numbers.value
  return { length: whole.format(link?.length ?? 0), limit: whole.format(LINK_LIMIT) }
}
