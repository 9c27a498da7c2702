/**
 * A card as elements: marked reads it, and every token becomes an element here. HTML in a card stays text, so nothing needs to be
 * sanitised; comments are not shown.
 */

import { marked, type Token, type Tokens } from 'marked'
import type { ComponentChildren, JSX } from 'preact'
import { t } from '../i18n/column'

/** Drawings that stand beside the cards, by their files' names. */
const pictures = import.meta.glob<string>('../../../docs/papers/*.svg', {
  query: '?url&no-inline',
  import: 'default',
  eager: true,
})

/** From here on a table cell is a sentence, which wants some width even on a phone. */
const WORDY = 36

/** How wide a text is in letters: a Chinese character is as wide as two. */
const lettersOf = (text: string) => text.replace(/[\u3000-\u9fff\uff00-\uffef]/g, '  ').length

export interface Card {
  title: string
  body: Token[]
}

/** The first heading is the card's title. */
export function readCard(text: string): Card {
  const tokens = marked.lexer(text)
  const first = tokens.findIndex(({ type }) => type === 'heading')
  const heading = tokens[first] as Tokens.Heading | undefined
  return { title: heading?.text ?? '', body: tokens.filter((_, i) => i !== first) }
}

export function Blocks({ tokens }: { tokens: Token[] }) {
  return <>{tokens.map((token, i) => block(token, i))}</>
}

function block(token: Token, key: number): ComponentChildren {
  switch (token.type) {
    case 'heading':
      return heading(token as Tokens.Heading, key)
    case 'paragraph':
      return <p key={key}>{inlines((token as Tokens.Paragraph).tokens)}</p>
    case 'text':
      return <span key={key}>{inlines((token as Tokens.Text).tokens ?? [token])}</span>
    case 'list':
      return list(token as Tokens.List, key)
    case 'table':
      return <Table key={key} table={token as Tokens.Table} />
    case 'code':
      return <Listing key={key} text={(token as Tokens.Code).text} />
    case 'blockquote':
      return (
        <blockquote key={key}>
          <Blocks tokens={(token as Tokens.Blockquote).tokens} />
        </blockquote>
      )
    case 'hr':
      return <hr key={key} />
    case 'space':
      return null
    case 'html':
      return token.raw.startsWith('<!--') ? null : <p key={key}>{token.raw}</p>
    default:
      return <p key={key}>{token.raw}</p>
  }
}

/** One level down: the dialog's title is the first heading of the card. */
function heading({ depth, tokens }: Tokens.Heading, key: number): JSX.Element {
  const Level = depth <= 2 ? 'h3' : 'h4'
  return <Level key={key}>{inlines(tokens)}</Level>
}

function list({ ordered, items }: Tokens.List, key: number): JSX.Element {
  const Kind = ordered ? 'ol' : 'ul'
  return (
    <Kind key={key}>
      {items.map((item, i) => (
        <li key={i}>
          <Blocks tokens={item.tokens} />
        </li>
      ))}
    </Kind>
  )
}

function Listing({ text }: { text: string }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="card-listing" tabIndex={0} aria-label={t('papers.listing')}>
      <pre>
        <code>{text}</code>
      </pre>
    </section>
  )
}

function Table({ table }: { table: Tokens.Table }) {
  const label = table.header.map(({ text }) => text).join(', ')
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="card-table" tabIndex={0} aria-label={label}>
      <table data-columns={table.header.length}>
        <thead>
          <tr>
            {table.header.map((cell, i) =>
              cell.text === '' ? (
                <td key={i} />
              ) : (
                <th key={i} scope="col">
                  {inlines(cell.tokens)}
                </th>
              ),
            )}
          </tr>
        </thead>
        <tbody>
          {table.rows.map((row, y) => (
            <tr key={y}>
              {row.map((cell, x) => (
                <td key={x} class={lettersOf(cell.text) > WORDY ? 'wordy' : undefined}>
                  {inlines(cell.tokens)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  )
}

function inlines(tokens: Token[]): ComponentChildren {
  return tokens.map((token, i) => inline(token, i))
}

function inline(token: Token, key: number): ComponentChildren {
  switch (token.type) {
    case 'strong':
      return <strong key={key}>{inlines((token as Tokens.Strong).tokens)}</strong>
    case 'em':
      return <em key={key}>{inlines((token as Tokens.Em).tokens)}</em>
    case 'codespan':
      return <code key={key}>{(token as Tokens.Codespan).text}</code>
    case 'link':
      return <Link key={key} link={token as Tokens.Link} />
    case 'image':
      return <Picture key={key} image={token as Tokens.Image} />
    case 'br':
      return <br key={key} />
    case 'del':
      return <del key={key}>{inlines((token as Tokens.Del).tokens)}</del>
    case 'text':
    case 'escape':
      return (token as Tokens.Text).text
    default:
      return token.raw
  }
}

/** A drawing of ours; of another one what it shows. */
function Picture({ image: { href, text } }: { image: Tokens.Image }) {
  const name = href.split('/').at(-1) ?? ''
  const source = pictures[`../../../docs/papers/${name}`]
  return source ? <img class="card-picture" src={source} alt={text} /> : <>{text}</>
}

/** Links into the repository lead nowhere from here: their words stay. */
function Link({ link }: { link: Tokens.Link }) {
  if (!/^https?:/.test(link.href)) return <>{inlines(link.tokens)}</>
  return (
    <a href={link.href} target="_blank" rel="noopener noreferrer">
      {inlines(link.tokens)}
    </a>
  )
}
