/**
 * Keeps the page for days without a network: all its files, fetched when the page rests, and from then on answered from the copy.
 *
 * A newer version is kept beside the one in use and waits until the reader asks for it, however often the page is opened: another engine
 * may give other results, and a lesson must not change in its middle. (A browser replaces a waiting service worker as soon as the page is
 * closed; so this one takes its place at once, and chooses by itself which version it answers with.)
 */
import { bytes, files, version } from 'virtual:files-of-page'
import { PrecacheController } from 'workbox-precaching/PrecacheController.js'
import type { KeepRequest, KeptPage, PageVersion } from '../model/kept_page'

declare const self: ServiceWorkerGlobalScope

const SCOPE = self.registration.scope
/** Several pages may live on one host. */
const PREFIX = `formicarium ${SCOPE} `
const NEWEST = PREFIX + version
/** Holds which version is in use. */
const CHOICE = `${PREFIX}in use`
const KEY = new URL('in-use', SCOPE).href

const controller = new PrecacheController({ cacheName: NEWEST, fallbackToNetwork: false })
controller.addToCacheList(files)

/** What is being removed answers nothing any more. */
let isGone = false

self.addEventListener('install', (event) => {
  controller.install(event)
  void self.skipWaiting()
})

self.addEventListener('activate', (event) => {
  event.waitUntil(tidy().then(() => self.clients.claim()))
})

self.addEventListener('fetch', (event) => {
  const { request } = event
  if (isGone || request.method !== 'GET' || !request.url.startsWith(SCOPE)) return
  event.respondWith(answer(request))
})

self.addEventListener('message', (event) => {
  const [port] = event.ports
  event.waitUntil(reply(event.data).then((told) => port?.postMessage(told)))
})

/** From the version in use; what it does not have, from the network. */
async function answer(request: Request): Promise<Response> {
  const name = await used()
  if (name === null) return fetch(request)
  const cache = await caches.open(name)
  const asked = isPage(request) ? fileAt('index.html') : request
  return (await cache.match(asked, { ignoreSearch: true })) ?? fetch(request)
}

/** The page itself, also where a program has written the `#` of a link as a code. */
function isPage({ mode, url }: Request): boolean {
  const path = new URL(url).pathname.slice(new URL(SCOPE).pathname.length)
  return mode === 'navigate' && /^(?:$|%23[xq](?:=|%3d))/i.test(path)
}

const fileAt = (name: string) => new URL(name, SCOPE).href

/** The cache of the version in use; null where none is whole. */
async function used(): Promise<string | null> {
  const chosen = (await caches.has(CHOICE))
    ? await (await (await caches.open(CHOICE)).match(KEY))?.text()
    : undefined
  for (const name of [chosen, NEWEST]) if (name && (await versionIn(name))) return name
  return null
}

/** Notes which version is in use, and keeps beside it the newest alone: another one that waited before is wanted no more. */
async function tidy(): Promise<void> {
  const now = (await used()) ?? NEWEST
  await (await caches.open(CHOICE)).put(KEY, new Response(now))
  await forget((name) => ![now, NEWEST, CHOICE].includes(name))
}

async function reply(request: KeepRequest): Promise<KeptPage | null> {
  switch (request.ask) {
    case 'look':
      return look()
    case 'use-newer':
      await (await caches.open(CHOICE)).put(KEY, new Response(NEWEST))
      await forget((name) => name !== NEWEST && name !== CHOICE)
      return null
    case 'forget':
      isGone = true
      await self.registration.unregister()
      await forget(() => true)
      return null
  }
}

async function look(): Promise<KeptPage | null> {
  const name = await used()
  const now = name && (await versionIn(name))
  if (!now) return null
  return { used: now, newer: name === NEWEST ? null : await versionIn(NEWEST), bytes }
}

async function versionIn(name: string): Promise<PageVersion | null> {
  if (!(await caches.has(name))) return null
  const cache = await caches.open(name)
  return (await cache.match(fileAt('version.json'), { ignoreSearch: true }))?.json() ?? null
}

async function forget(which: (name: string) => boolean): Promise<void> {
  const own = (await caches.keys()).filter((name) => name.startsWith(PREFIX))
  await Promise.all(own.filter(which).map((name) => caches.delete(name)))
}
