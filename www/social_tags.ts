/** The tags by which programs show a card for an address. docs/hosting.md tells of them. */
import type { Plugin } from 'vite'

/** Where the page will be, with a slash at its end: cards take pictures from absolute addresses alone. The description stands in index.html. */
const ADDRESS = process.env.FORMICARIUM_ADDRESS ?? './'

export function socialTags(): Plugin {
  const image = `${ADDRESS.replace(/\/*$/, '/')}social.png`
  return {
    name: 'formicarium:social-tags',
    apply: 'build',
    transformIndexHtml: () =>
      [
        ['property', 'og:title', 'Formicarium'],
        ['property', 'og:image', image],
        ['name', 'twitter:card', 'summary_large_image'],
      ].map(([key = '', name = '', content = '']) => ({
        tag: 'meta',
        attrs: { [key]: name, content },
        injectTo: 'head' as const,
      })),
  }
}
