/**
 * What the page may load and run, written into the built index.html: its own files, WebAssembly, and the one inline script, by its
 * hash. docs/hosting.md has the same for servers that send headers.
 */
import { createHash } from 'node:crypto'
import type { Plugin } from 'vite'

const POLICY: Record<string, string[]> = {
  'default-src': ["'self'"],
  'script-src': ["'self'", "'wasm-unsafe-eval'"],
  // Pictures that are dropped, and those that are saved.
  'img-src': ["'self'", 'data:', 'blob:'],
  'object-src': ["'none'"],
  'base-uri': ["'none'"],
  'form-action': ["'none'"],
}

/** Scripts that stand in the page itself. */
const INLINE = /<script>([\s\S]*?)<\/script>/g

function policyOf(html: string): string {
  const hash = (script: string) =>
    `'sha256-${createHash('sha256').update(script).digest('base64')}'`
  const hashes = [...html.matchAll(INLINE)].map(([, script = '']) => hash(script))
  const sources = (name: string, all: string[]) =>
    name === 'script-src' ? [...all, ...hashes] : all
  return Object.entries(POLICY)
    .map(([name, all]) => [name, ...sources(name, all)].join(' '))
    .join('; ')
}

export function contentSecurity(): Plugin {
  return {
    name: 'formicarium:content-security',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler: (html) => [
        {
          tag: 'meta',
          attrs: { 'http-equiv': 'Content-Security-Policy', content: policyOf(html) },
          injectTo: 'head-prepend',
        },
      ],
    },
  }
}
