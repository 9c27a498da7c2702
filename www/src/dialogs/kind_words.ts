/** What a file was recognised as, in words. */
import type { Kind } from '@pkg/formicarium'
import { engineText } from '../i18n'
import { type DialogKey, t } from '../i18n/dialogs'

export const kindName = (kind: Kind) => t(`kinds.${kind}` as DialogKey)

/** By what it was told: the engine says it in English. */
export const whyWords = (why: string) =>
  engineText(`whys.${why.toLowerCase().replace(/[^a-z0-9]+/g, '-')}`, why)
